//! Benchmarks, run with `cargo bench -p contact-scaling`: a drop test takes at most 2 ms, closed forms take nanoseconds.

#![allow(clippy::unwrap_used)]

use std::hint::black_box;

use contact_scaling::drop_test::DropTest;
use contact_scaling::{Contact, ContactValues, HuntCrossley, Ratios, SmoothSphere, falisse2022, restitution};
use criterion::{Criterion, criterion_group, criterion_main};

fn closed_forms(c: &mut Criterion) {
    let human = falisse2022();
    let hunt_crossley = HuntCrossley::of(&human.contact, 0.032).unwrap();
    let smooth = SmoothSphere::of(&human.contact, 0.032).unwrap();
    c.bench_function("force of HuntCrossleyForce", |b| {
        b.iter(|| hunt_crossley.force(black_box(0.0113), black_box(0.1)));
    });
    c.bench_function("force of SmoothSphereHalfSpaceForce", |b| {
        b.iter(|| smooth.force(black_box(0.0113), black_box(0.1)));
    });
    c.bench_function("rescale a contact", |b| {
        b.iter(|| black_box(human.contact).scaled(&Ratios::isometric(black_box(19.2)).unwrap()));
    });
    c.bench_function("exact restitution", |b| {
        b.iter(|| restitution::exact(black_box(2.0), black_box(0.396)).unwrap());
    });
}

fn drop_tests(c: &mut Criterion) {
    let human = falisse2022();
    let plain = Contact::new(ContactValues { smoothing: None, ..human.contact.values() }).unwrap();
    for (name, contact) in [("drop test, Hunt-Crossley", plain), ("drop test, smooth", human.contact)] {
        let test = DropTest::of(&contact, &human.scale, 0.25, 2.0).unwrap();
        c.bench_function(name, |b| b.iter(|| test.run().unwrap()));
    }
}

criterion_group!(benches, closed_forms, drop_tests);
criterion_main!(benches);
