//! Bytes of a file that go, so that many places can be asked about.

use std::ops::Range;

/// Spans in order, none inside another one.
pub(super) struct Covered(Vec<Range<usize>>);

impl Covered {
    /// Those of `spans` that are in no other one of them. Spans do not overlap otherwise: they are elements.
    pub(super) fn of(mut spans: Vec<Range<usize>>) -> Self {
        // The longer first where two begin together.
        spans.sort_by_key(|span| (span.start, std::cmp::Reverse(span.end)));
        let mut end = 0;
        spans.retain(|span| {
            let is_outer = span.end > end;
            end = end.max(span.end);
            is_outer
        });
        Self(spans)
    }

    /// Whether all of `span` goes.
    pub(super) fn covers(&self, span: &Range<usize>) -> bool {
        let behind = self.0.partition_point(|own| own.start <= span.start);
        self.0[..behind].last().is_some_and(|own| span.end <= own.end)
    }

    /// The spans, in order.
    pub(super) fn spans(&self) -> &[Range<usize>] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_inside_of_what_goes_goes_with_it() {
        let covered = Covered::of(vec![20..30, 0..10, 20..25, 26..30, 2..3]);
        assert_eq!(covered.spans(), [0..10, 20..30]);
        for (span, goes) in
            [(0..10, true), (2..9, true), (9..11, false), (10..20, false), (25..26, true), (31..32, false)]
        {
            assert_eq!(covered.covers(&span), goes, "{span:?}");
        }
        assert!(!Covered::of(Vec::new()).covers(&(0..1)));
    }
}
