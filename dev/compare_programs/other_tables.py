"""Tables of calls about the calculator, drops, presets, and what is told of wrong calls; one call a line, in the language of `calls.py`."""

SHEETS = r"""
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --gravity 9.81
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --gravity 9.81 --constant-indentation 0.1 --state-width 0.3
design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16 --restitution 0.8 --impact-speed 0.4
design --mass 0.0209 --spheres 2 --radius 0.002 --indentation 0.3533 --gravity 9.81 --format json
design --load 300 --spheres 1 --contact-stiffness 150000 --indentation 0.1
design --mass 62 --body-weights 2.5 --spheres 6 --radius 0.032 --indentation 0.1 --gravity 9.81 --format json
design --young 1e5 --poisson 0.49
design --young 1e5 --poisson -0.5 --format json
design --restitution 0.208 --impact-speed 0.396
design --restitution 0.9 --radius 0.032 --gravity 9.81 --format json
design --restitution 0.1 --impact-speed 2
design --restitution 1 --impact-speed 2
design --restitution 0 --impact-speed 2
design --radius 0.032 --constant-indentation 0.1 --state-width 0.3 --speed-width 0.25 --threshold 0.01
design --radius 0.032 --restitution 0.9 --constant-indentation 0.1 --state-width 0.3 --speed-width 0.3
design --mass 62 --radius 0.032
design --mass 62 --radius 0.032 --indentation 0.2
design --spheres 6 --radius 0.032 --indentation 0.2
design --mass 62 --spheres 6 --indentation 0.2
design --restitution 0.9
design --constant-indentation 0.1
design --state-width 0.1
design --body-weights 2 --spheres 6
design --young 1e5
design --poisson 0.3
design --mass 62 --spheres 6 --radius 0.032 --indentation 0.3533 --stiffness 2e6 --gravity 9.81
design --mass 62 --spheres 6 --radius 0.032 --indentation 0.3533 --contact-stiffness 5000
design --load 300 --spheres 1 --indentation 0.1 --radius 0.03 --contact-stiffness 1e5
design --indentation 1.5
design --restitution 1.1
design --young 1e5 --poisson 0.6
design --threshold 0.5 --radius 1
design --radius keep
design --radius x1.5
design --load 5 --body-weights 5
design --stiffness 1e6 --young 1e5 --poisson 0.3
design --mass 62 --spheres 6 --radius 0.0032 --stiffness 1e5
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --format lines
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --dry-run
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 -o out.osim
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --report page.html
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --stance-limbs 2
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --select *_r
design human.osim
design human.osim --stiffness 1e6
design human.osim --young 1e5 --poisson 0.3 --indentation 0.2
design human.osim --contact-stiffness 1e4
design human.osim --contact-stiffness 1e4 --indentation 0.1 --radius 0.03
design human.osim --contact-stiffness 13449.5 --indentation 0.16
design counts.osim --indentation 0.1
design weightless.osim --indentation 0.1 --spheres 2
design weightless.osim --restitution 0.9
design human.osim --indentation 0.16 --constant-indentation 0.05 --restitution 0.8 -o mended.osim --format lines && check mended.osim
design human.osim --indentation 0.16 --restitution 0.9 --constant-indentation 0.05 --state-width 0.3 --speed-width 0.3 -o out.osim && out.osim --target-mass 500 --dry-run
drop-test
drop-test --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --dissipation 0.1
drop-test --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --dissipation 0 --format json --samples 11
drop-test --mass 62 --spheres 6 --radius 0.032 --dissipation 2
drop-test --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --dissipation 2 --hertz-smoothing 300
drop-test --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --dissipation 2 --hertz-smoothing 300 --constant-contact-force 1e-5 --hunt-crossley-smoothing 50
drop-test falisse2022
drop-test falisse2022 --format csv --samples 5
drop-test falisse2022 --mass 5 --spheres 2 --gravity 1.62
drop-test falisse2022 --compare falisse2022
drop-test human.osim --height 10 --duration 0.5
drop-test human.osim --height 0
drop-test human.osim --height x0.5 --samples 2 --format json
drop-test human.osim --radius 0.1
drop-test human.osim --hertz-smoothing 100
drop-test human.osim --samples 1
drop-test human.osim --samples 2000000
drop-test human.osim --height 8mm
drop-test human.osim --duration 0
drop-test human.osim mouse.osim
drop-test rat.osim --stance-limbs 2 --compare hunt.osim
drop-test scaled.osim --compare generic.osim --format json --samples 5
drop-test human.osim --compare nobody
drop-test human.osim --compare truncated.osim
drop-test human.osim --compare-spheres 2
drop-test ball.osim
drop-test ball.osim --format json
drop-test ball.osim --select ball_floor
drop-test ball.osim --select ball_floor --spheres 1
drop-test weightless.osim
drop-test weightless.osim --gravity 9.81
drop-test none.osim
drop-test nowhere.osim
drop-test lib
drop-test nobody2022
presets
presets falisse2022
presets falisse2022 --format json
presets falise2022
presets falisse2022 lab_heel
presets --format csv
presets ''
set human.osim
set stiffness=2
set human.osim stifness=2
set human.osim mass=80
set human.osim stiffness=1 stiffness=2
set human.osim stiffness=1,5e6
set human.osim stiffness=
set human.osim =2
set human.osim stiffness=-2
set human.osim stiffness=x-2
set human.osim stiffness=nan
set human.osim stiffness=x0
set human.osim stiffness=1e400
set human.osim radius=-1
set human.osim 'stiffness = 2'
set hunt.osim hertz_smoothing=300
set materials.osim stiffness=x2 --dry-run --format json
set human.osim hertz_smoothing=300
set human.osim stiffness=x2 dissipation=1 --select nothing*
transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 2
transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 4 -o four.osim && four.osim --target-mass 0.0418 -o twice.osim
transfer horse.osim --from human.osim --stance-limbs 2 --dry-run
transfer human.osim --from unlike.osim --dry-run
transfer counts.osim --from falisse2022
transfer sideless.osim --from falisse2022
transfer mouse.osim --from falise2022
transfer mouse.osim --from falisse2022 --contacts-mass 62
:put falisse2022 x && transfer mouse.osim --from falisse2022 --spheres 2 --dry-run && transfer mouse.osim --from ./falisse2022 --spheres 2
:copy human.osim ref && transfer mouse.osim --from ref --spheres 2
transfer human.osim --from human.osim
transfer human.osim --from lib
transfer human.osim --from truncated.osim --format json
transfer human.osim --from human.osim --in-place
transfer human.osim --from mouse.osim -o mouse.osim --force
transfer human.osim --from falisse2022 --reference-sphere s1_r
transfer human.osim --from unlike.osim --reference-sphere nothing
transfer human.osim --from mouse.osim --reference-select nothing*
shared.osim --target-mass 100 --select contact_1
shared.osim --target-mass 100
ball.osim --target-mass 500
ball.osim --target-mass 500 --select contact_*
human.osim --target-mass 500 --select nothing*
human.osim --target-mass 500 --select *_r --select *_l --exclude *s1*
human.osim --target-mass 500 --exclude *
human.osim --target-mass 500 --exclude-body *
human.osim --target-mass 500 --exclude-body nothing*
terrain.osim --target-mass 500
human.osim --target-mass 500 --only radius --keep radius
human.osim --target-mass 500 --only radius,radius
human.osim --target-mass 500 --only stiffness --friction
human.osim --target-mass 500 --keep radius,stiffness,dissipation,constant_contact_force,hertz_smoothing,hunt_crossley_smoothing
human.osim --target-mass 1e-300
human.osim --target-mass 1e300
human.osim --target-mass 500 --radius x1e-300
human.osim --target-mass 500 --radius 1e300
human.osim --target-mass 500 --target-gravity 1e-300
human.osim --target-mass 500 --only stiffness --radius 0.04
human.osim --target-mass 500 --radius keep --level
human.osim --diff
human.osim --mass 70
human.osim --contacts-mass 70 --format json
human.osim --jobs 1
human.osim --force
human.osim --no-note
human.osim --quiet
--target-mass 5
rescale --target-mass 5
rescale human.osim
rescal human.osim
transfer
transfer --from falisse2022
inspect
check
batch
set
transfer emu.osim --from radii.osim --reference-spheres 2 --radius isometric
transfer human.osim --from mixed.osim --reference-spheres 2 --radius isometric
transfer human.osim --from mixed.osim --reference-spheres 2 --radius isometric --reference-sphere heel_r
transfer human.osim --from radii.osim --reference-spheres 2
"""
