//! How a function is declared: its name and arguments once, each argument with its symbol in the register.

/// A [`Function`](super::Function): `name(argument: SYMBOL, another: SYMBOL = 1.0) -> what it gives, "the function of
/// contact-scaling", value`. With `[rule]` in front it also takes the rule by which two surfaces make one modulus.
macro_rules! function {
    ([$rule:ident] $name:ident $arguments:tt -> $returns:expr, $computes:literal, $value:expr) => {
        function!(@of $name, $arguments, $returns, $computes,
            $crate::scaling::Call::WithRule(|$rule, values| function!(@value values, $arguments, $value)))
    };
    ($name:ident $arguments:tt -> $returns:expr, $computes:literal, $value:expr) => {
        function!(@of $name, $arguments, $returns, $computes,
            $crate::scaling::Call::Numbers(|values| function!(@value values, $arguments, $value)))
    };
    (@of $name:ident, ($($argument:ident: $symbol:ident $(= $default:literal)?),+), $returns:expr, $computes:literal, $call:expr) => {
        $crate::scaling::Function {
            name: stringify!($name),
            computes: $computes,
            parameters: &[$($crate::scaling::define::parameter!($argument: $symbol $(= $default)?)),+],
            returns: $returns,
            call: $call,
        }
    };
    (@value $values:ident, ($($argument:ident: $symbol:ident $(= $default:literal)?),+), $value:expr) => {{
        let &[$($argument),+] = $values else {
            return Err($crate::scaling::Failure::arguments($values.len()));
        };
        Ok($value)
    }};
}

/// A [`Parameter`](super::Parameter): `name: SYMBOL`, or `name: SYMBOL = 1.0`.
macro_rules! parameter {
    ($name:ident: $symbol:ident $(= $default:literal)?) => {
        $crate::scaling::Parameter {
            name: stringify!($name),
            symbol: contact_scaling::equations::symbols::$symbol,
            default: $crate::scaling::define::parameter!(@default $($default)?),
        }
    };
    (@default) => { None };
    (@default $default:literal) => { Some($default) };
}

pub(super) use {function, parameter};
