//! Things that were made once, each of another type, and are kept.

use std::any::Any;
use std::sync::OnceLock;

/// The first of a chain of such things. None is ever taken out, so that they are lent as long as the chain lives.
#[derive(Debug, Default)]
pub(crate) struct Made(OnceLock<Box<Link>>);

#[derive(Debug)]
struct Link {
    thing: Box<dyn Any + Send + Sync>,
    next: Made,
}

impl Made {
    /// The thing of type `T`, made if there is none yet. Two threads may both make one; the first counts.
    pub(crate) fn get_or_make<T: Any + Send + Sync>(&self, make: impl FnOnce() -> T) -> &T {
        if let Some(known) = self.get() {
            return known;
        }
        // What is made may ask for other things meanwhile.
        let mut new = Some(Box::new(Link { thing: Box::new(make()), next: Self::default() }));
        let mut at = self;
        loop {
            new = new.and_then(|link| at.0.set(link).err());
            if let Some(known) = self.get() {
                return known;
            }
            if let Some(link) = at.0.get() {
                at = &link.next;
            }
        }
    }

    fn get<T: Any>(&self) -> Option<&T> {
        let links = std::iter::successors(self.0.get(), |link| link.next.0.get());
        links.into_iter().find_map(|link| link.thing.downcast_ref())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_thing_is_made_once() {
        let made = Made::default();
        let number = made.get_or_make(|| {
            assert_eq!(made.get_or_make(|| "made meanwhile"), &"made meanwhile");
            1_i32
        });
        assert_eq!((number, made.get_or_make(|| 2_i32)), (&1, &1));
        assert_eq!((made.get_or_make(|| "another"), made.get_or_make(|| 3_u8)), (&"made meanwhile", &3));
    }
}
