"""Modules with a function `task`, and one thing in them that changes what it returns: name, text, what is there, what comes in its place."""

CASES = {
    "default argument from a constant": (
        """\
F = 2
def task(path, index=0, factor=F):
    return {'v': factor}
""",
        "F = 2",
        "F = 3",
    ),
    "kw-only default in helper": (
        """\
F = 2
def h(x, k=F):
    return x*k
def task(path):
    return {'v': h(1)}
""",
        "F = 2",
        "F = 3",
    ),
    "functools.partial keyword": (
        """\
import functools
def f(path, k):
    return {'v': k}
task = functools.partial(f, k=2)
""",
        "k=2",
        "k=3",
    ),
    "functools.partial body": (
        """\
import functools
def f(path, k):
    return {'v': k}
task = functools.partial(f, k=2)
""",
        "'v': k",
        "'v': k*9",
    ),
    "base class": (
        """\
class B:
    def __call__(self, path):
        return {'v': 1}
class T(B):
    pass
task = T()
""",
        "'v': 1",
        "'v': 2",
    ),
    "mixin in used class": (
        """\
class B:
    def go(self):
        return 1
class T(B):
    pass
def task(path):
    return {'v': T().go()}
""",
        "return 1",
        "return 2",
    ),
    "staticmethod uses constant": (
        """\
F = 2
class T:
    @staticmethod
    def go():
        return F
def task(path):
    return {'v': T.go()}
""",
        "F = 2",
        "F = 3",
    ),
    "property uses constant": (
        """\
F = 2
class T:
    @property
    def go(self):
        return F
def task(path):
    return {'v': T().go}
""",
        "F = 2",
        "F = 3",
    ),
    "class attribute from constant": (
        """\
F = 2
class T:
    k = F
def task(path):
    return {'v': T.k}
""",
        "F = 2",
        "F = 3",
    ),
    "slots dataclass": (
        """\
import dataclasses
@dataclasses.dataclass(frozen=True, slots=True)
class T:
    k: int
    def __call__(self, path):
        return {'v': self.k}
K = 2
task = T(K)
""",
        "K = 2",
        "K = 3",
    ),
    "namedtuple": (
        """\
from typing import NamedTuple
class T(NamedTuple):
    k: int
    def __call__(self, path):
        return {'v': self.k}
K = 2
task = T(K)
""",
        "K = 2",
        "K = 3",
    ),
    "decorator body": (
        """\
import functools
def twice(f):
    @functools.wraps(f)
    def g(path):
        return {'v': f(path)['v'] * 2}
    return g
@twice
def task(path):
    return {'v': 1}
""",
        "* 2",
        "* 3",
    ),
    "decorator constant": (
        """\
import functools
K = 2
def times(k):
    def d(f):
        @functools.wraps(f)
        def g(path):
            return {'v': f(path)['v'] * k}
        return g
    return d
@times(K)
def task(path):
    return {'v': 1}
""",
        "K = 2",
        "K = 3",
    ),
    "second lambda": (
        """\
f = lambda x: x + 1
g = lambda x: x + 2
def task(path):
    return {'v': f(1) + g(1)}
""",
        "x + 2",
        "x + 3",
    ),
    "first lambda": (
        """\
f = lambda x: x + 1
g = lambda x: x + 2
def task(path):
    return {'v': f(1) + g(1)}
""",
        "x + 1",
        "x + 3",
    ),
    "two closures of one factory, first": (
        """\
def make(k):
    def inner(x):
        return x * k
    return inner
a = make(1)
b = make(2)
def task(path):
    return {'v': a(1) + b(1)}
""",
        "make(1)",
        "make(7)",
    ),
    "two closures of one factory, second": (
        """\
def make(k):
    def inner(x):
        return x * k
    return inner
a = make(1)
b = make(2)
def task(path):
    return {'v': a(1) + b(1)}
""",
        "make(2)",
        "make(7)",
    ),
    "lambdas on one line": (
        """\
tasks = [lambda path: {'v': 1}, lambda path: {'v': 2}]
W = 0
task = tasks[W]
""",
        "W = 0",
        "W = 1",
    ),
    "lambda default in a loop": (
        """\
N = 2
task = lambda path, k=N: {'v': k}
""",
        "N = 2",
        "N = 3",
    ),
    "numpy global, long": (
        """\
import numpy as np
A = np.zeros(5000)
A[2500] = 2
def task(path):
    return {'v': A.sum()}
""",
        "= 2",
        "= 3",
    ),
    "numpy global, digits": (
        """\
import numpy as np
A = np.array([1.000000001])
def task(path):
    return {'v': A.sum()}
""",
        "1.000000001",
        "1.000000002",
    ),
    "pandas global": (
        """\
import pandas as pd
A = pd.DataFrame({'a': range(100)})
A.loc[50, 'a'] = 2
def task(path):
    return {'v': A.a.sum()}
""",
        "= 2",
        "= 3",
    ),
    "numpy in closure": (
        """\
import numpy as np
K = 2
def make(a):
    def task(path):
        return {'v': a.sum()}
    return task
a = np.zeros(5000); a[2500] = K
task = make(a)
""",
        "K = 2",
        "K = 3",
    ),
    "numpy attribute of instance": (
        """\
import numpy as np
K = 2
class T:
    def __init__(self, a):
        self.a = a
    def __call__(self, path):
        return {'v': self.a.sum()}
a = np.zeros(5000); a[2500] = K
task = T(a)
""",
        "K = 2",
        "K = 3",
    ),
    "function __wrapped__-less decorator": (
        """\
def deco(f):
    def g(path):
        return {'v': f(path)['v'] * 2}
    return g
@deco
def task(path):
    return {'v': 1}
""",
        "'v': 1",
        "'v': 5",
    ),
    "object of a class in module as global": (
        """\
class C:
    def __init__(self, k):
        self.k = k
    def __repr__(self):
        return 'C'
c = C(2)
def task(path):
    return {'v': c.k}
""",
        "C(2)",
        "C(3)",
    ),
    "global instance, method body": (
        """\
import dataclasses
@dataclasses.dataclass
class C:
    k: int
    def go(self):
        return self.k * 2
c = C(2)
def task(path):
    return {'v': c.go()}
""",
        "* 2",
        "* 3",
    ),
    "instance attribute of own class, method body": (
        """\
import dataclasses
@dataclasses.dataclass
class C:
    k: int
    def go(self):
        return self.k * 2
@dataclasses.dataclass
class T:
    c: C
    def __call__(self, path):
        return {'v': self.c.go()}
task = T(C(2))
""",
        "* 2",
        "* 3",
    ),
    "helper called in a default factory of function attribute": (
        """\
def task(path):
    return {'v': task.k}
task.k = 2
""",
        "k = 2",
        "k = 3",
    ),
    "bound method": (
        """\
class T:
    def __init__(self, k):
        self.k = k
    def go(self, path):
        return {'v': self.k}
task = T(2).go
""",
        "T(2)",
        "T(3)",
    ),
    "same-named constant in two closures": (
        """\
def make(k):
    def one(x):
        return x * k
    return one
def make2(k):
    def two(x):
        return x * k
    return two
f = make(1)
g = make2(5)
def task(path):
    return {'v': f(1) + g(1)}
""",
        "make(1)",
        "make(8)",
    ),
    "metaclass/inherited dataclass field default": (
        """\
F = 2
import dataclasses
@dataclasses.dataclass
class C:
    k: int = F
def task(path):
    return {'v': C().k}
""",
        "F = 2",
        "F = 3",
    ),
    "class used only in annotation-less nested function default": (
        """\
F = 2
def task(path):
    def inner(k=F):
        return k
    return {'v': inner()}
""",
        "F = 2",
        "F = 3",
    ),
    "comprehension/inner class": (
        """\
F = 2
def task(path):
    class C:
        k = F
    return {'v': C.k}
""",
        "F = 2",
        "F = 3",
    ),
}
