"""Tables of calls about followed bodies, sweeps, plots, measurements and the like; one call a line, in the language of `calls.py`."""

# Models that OpenSim scaled.
FOLLOW = r"""
transfer scaled.osim --from generic.osim --follow-bodies
transfer scaled.osim --from generic.osim --follow-bodies --level --diff
transfer scaled.osim --from generic.osim --follow-bodies --level --level-axis z --dry-run --format json
transfer scaled.osim --from generic.osim --follow-bodies --level --level-axis -x --dry-run
transfer scaled.osim --from generic.osim --follow-bodies --rule predsim --dry-run
transfer scaled.osim --from generic.osim --follow-bodies --rule predsim --height-ratio 0.93 --dry-run --format json
transfer scaled.osim --from generic.osim --rule predsim
transfer scaled.osim --from generic.osim --rule predsim --height-ratio 0.93
transfer scaled.osim --from generic.osim --follow-bodies --height-ratio 0.93
transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file applied.xml --report page.html
transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file generic.osim
transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file nowhere.xml
transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file setup_smooth.xml
transfer scaled.osim --from generic.osim --follow-bodies --body-scale hoof=1,1,1
transfer scaled.osim --from generic.osim --follow-bodies --body-scale calcn_r=1,0,1
transfer scaled.osim --from generic.osim --follow-bodies --body-scale calcn_r=1,nan,1
transfer scaled.osim --from generic.osim --follow-bodies --body-scale calcn_r=1,1
transfer scaled.osim --from generic.osim --follow-bodies --body-scale toes_r=1.1,1.1,1.1
transfer scaled_hunt.osim --from generic_hunt.osim --follow-bodies --body-scale toes_r=1.1,1.1,1.1
transfer scaled_hunt.osim --from generic_hunt.osim --follow-bodies --body-scale toes_r=1.1,1.1,1.1 --strict
transfer scaled_hunt.osim --from generic_hunt.osim --follow-bodies --strict --level
transfer scaled_hunt.osim --from generic.osim --follow-bodies
transfer scaled.osim --from generic.osim --follow-bodies --radius-axis x --dry-run
transfer scaled.osim --from generic.osim --follow-bodies --radius-axis min --dry-run --format json
transfer scaled.osim --from generic.osim --follow-bodies --radius-axis max --keep radius --level
transfer scaled.osim --from generic.osim --follow-bodies --radius isometric
transfer scaled.osim --from generic.osim --level
transfer scaled.osim --from falisse2022 --follow-bodies
transfer scaled.osim --from none.osim --follow-bodies
transfer scaled.osim --from generic.osim --follow-bodies -o done.osim && transfer done.osim --from generic.osim --follow-bodies && transfer done.osim --from generic.osim --follow-bodies --moved-spheres keep && drop-test done.osim --compare generic.osim
transfer scaled.osim --from generic.osim --follow-bodies --moved-spheres keep --select *heel*
transfer scaled.osim scaled_hunt.osim --from generic.osim --follow-bodies -d out
transfer scaled.osim --from generic.osim --follow-bodies --in-place && transfer scaled.osim --from generic.osim --follow-bodies --in-place
transfer scaled.osim --from generic.osim --follow-bodies -o - --quiet
transfer scaled.osim --from generic.osim --follow-bodies --summary s.csv && transfer scaled.osim --from generic.osim --follow-bodies --summary s.csv --resume
inspect scaled.osim --from generic.osim
inspect scaled.osim --from generic.osim --body-scale-file applied.xml --report page.html
inspect scaled.osim --from generic.osim --format csv
inspect scaled.osim --from human.osim
inspect scaled.osim --from falisse2022
inspect scaled.osim --from nowhere.osim
inspect scaled.osim --body-scale-file applied.xml
inspect scaled_hunt.osim --from generic_hunt.osim --format json
transfer v40000_dhondt_2024_3seg_human.osim --from v40000_falisse_2022_human.osim --follow-bodies
transfer v40000_dhondt_2024_3seg_human.osim --from v40000_falisse_2022_human.osim --reference-sphere s1_r --format json
inspect v40000_dhondt_2024_3seg_human.osim --from v40000_falisse_2022_human.osim
batch follow.csv --summary s.csv
transfer scaled.osim --from generic.osim --follow-bodies --radius-axis z --dry-run --format json
transfer scaled.osim --from generic.osim --follow-bodies --level --level-axis x --dry-run
transfer scaled.osim --from generic.osim --follow-bodies --level --level-axis y --dry-run
transfer scaled.osim --from generic.osim --follow-bodies --level --level-axis -z --dry-run
:copy materials.osim twice.osim && transfer twice.osim --from materials.osim --follow-bodies --body-scale calcn_r=2,2,2 --body-scale calcn_l=2,2,2
:copy materials.osim twice.osim && transfer twice.osim --from materials.osim --follow-bodies --body-scale calcn_r=2,2,2 --body-scale calcn_l=2,2,2 --rule predsim --format json
:copy materials.osim twice.osim && :once twice.osim <stiffness> <stiffness>9 && transfer twice.osim --from materials.osim --follow-bodies --body-scale calcn_r=2,2,2 --body-scale calcn_l=2,2,2
:copy materials.osim twice.osim && :once twice.osim <dissipation> <dissipation>9 && transfer twice.osim --from materials.osim --follow-bodies --body-scale calcn_r=2,2,2 --body-scale calcn_l=2,1,2 --level
:once generic.osim <stiffness>2 <stiffness>3 && transfer scaled_hunt.osim --from generic.osim
:once generic.osim <stiffness>2 <stiffness>3 && transfer scaled.osim --from generic.osim --follow-bodies
:once generic.osim <stiffness>2 <stiffness>3 && transfer scaled_hunt.osim --from generic.osim --follow-bodies
:edit generic.osim <mass> <mass>x && transfer scaled.osim --from generic.osim --follow-bodies && transfer scaled.osim --from generic.osim --follow-bodies --reference-mass 62 && transfer scaled.osim --from generic.osim
:edit scaled.osim <mass> <mass>x && transfer scaled.osim --from generic.osim --follow-bodies && transfer scaled.osim --from generic.osim --follow-bodies --mass 52
:edit generic.osim <gravity> <gravity>x && transfer scaled.osim --from generic.osim && transfer scaled.osim --from generic.osim --target-gravity 1.62 && transfer scaled.osim --from generic.osim --reference-gravity 9.81 --target-gravity 1.62
:edit applied.xml <segment>femur_r <segment>pelvis && transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file applied.xml
:edit applied.xml <segment>calcn_r <segment>nothing && transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file applied.xml
:edit applied.xml <apply>true <apply>false && transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file applied.xml
:edit applied.xml </scales> ' 1</scales>' && transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file applied.xml
:edit generic.osim .vtp x.vtp && :edit scaled.osim .vtp x.vtp && transfer scaled.osim --from generic.osim --follow-bodies
:edit generic.osim _geom_1 _geom && transfer scaled.osim --from generic.osim --follow-bodies && inspect scaled.osim --from generic.osim
:edit generic.osim <orientation>0. '<orientation>0 0 1.5707963267948966' && transfer scaled.osim --from generic.osim --follow-bodies --level
:edit generic.osim name="heel_r" name="heel_x" && transfer scaled.osim --from generic.osim --follow-bodies
:edit scaled.osim name="toe_l" name="toe_x" && transfer scaled.osim --from generic.osim --follow-bodies
:edit scaled.osim calcn_r calcn_x && transfer scaled.osim --from generic.osim --follow-bodies
:edit generic.osim heel_r heel_x && transfer scaled.osim --from generic.osim --follow-bodies && inspect scaled.osim --from generic.osim
:edit scaled.osim heel_r heel_x && transfer scaled.osim --from generic.osim --follow-bodies && inspect scaled.osim --from generic.osim
:copy sideless.osim same.osim && transfer sideless.osim --from same.osim --follow-bodies --body-scale foot_a=1.1,1,1 --body-scale foot_b=1.1,1,1
"""

SWEEPS = r"""
sweep emu.osim --grid stiffness=x0.1,x1,x10 --grid dissipation=0.5,1,2
sweep emu.osim --grid stiffness=x1 --grid dissipation=2 -d own --no-note
sweep emu.osim --grid indentation=0.05,0.16 --grid restitution=0.8,0.9 -d out --no-note
sweep emu.osim --grid target-mass=5,500 --no-note -d out
sweep emu.osim --grid radius=x2 --grid indentation=0.16 -d mixed --format json
sweep emu.osim --grid radius=0.01..0.03/3 --restitution 0.8 --impact-speed 0.4
sweep emu.osim --grid indentation=0.05..0.16/4 --body-weights 2 --stance-limbs 2
sweep emu.osim --grid constant_contact_force=1e-6,x2 --grid hertz_smoothing=x0.5..x2/3
sweep emu.osim --ladder 4 --indentation 0.16 --restitution 0.9 -d out
sweep emu.osim --ladder 2 --indentation 0.1 --load 500 --soft 1.5
sweep emu.osim --ladder 3 --indentation 0.16 --jobs 1 --quiet
sweep emu.osim --ladder 3 --indentation 0.16 --dry-run --format json
sweep emu.osim --grid stiffness=x0.1..x10/101 --grid dissipation=0.1..10/100
sweep emu.osim --grid stiffness=x0.1..x10/9 --dry-run
sweep emu.osim --grid stiffness=1..9/1000 --grid dissipation=1..9/1000 --grid radius=1..9/1000 --dry-run
sweep emu.osim --grid stiffness=x1,x2 -d out && sweep emu.osim --grid stiffness=x1,x2 -d out && sweep emu.osim --grid stiffness=x1,x2 -d out --force --format json
sweep emu.osim
sweep
sweep emu.osim human.osim --grid stiffness=x2
sweep emu.osim --grid stifness=x2
sweep emu.osim --grid stiffness=x2,x2
sweep emu.osim --grid stiffness=2e6,2000000
sweep emu.osim --grid stiffness=x2 --grid stiffness=x3
sweep emu.osim --grid stiffness=x0.1..x10
sweep emu.osim --grid stiffness=
sweep emu.osim --grid stiffness
sweep emu.osim --grid =x2
sweep emu.osim --grid stiffness=x1..2/3
sweep emu.osim --grid stiffness=10..1/3
sweep emu.osim --grid stiffness=1,5e6
sweep emu.osim --grid stiffness=20kg
sweep emu.osim --grid target-mass=20kg
sweep emu.osim --grid indentation=0.1 --grid stiffness=x2
sweep emu.osim --grid indentation=0.1 --grid target-mass=2
sweep emu.osim --grid indentation=0.1 --indentation 0.2
sweep emu.osim --grid indentation=0.1,2
sweep emu.osim --grid stiffness=1e5,0,x2
sweep emu.osim --grid dissipation=1,2 --grid restitution=1.5
sweep emu.osim --ladder 1 --indentation 0.16
sweep emu.osim --ladder 3 --indentation 0.16 --soft 20
sweep emu.osim --ladder 3
sweep emu.osim --ladder 3 --indentation 0.16 --grid stiffness=x2
sweep emu.osim --grid stiffness=x2 --soft 2
sweep - --grid stiffness=x2
sweep nowhere.osim --grid stiffness=x2
sweep none.osim --grid stiffness=x2
sweep lib --grid stiffness=x2
sweep truncated.osim --grid stiffness=x2 --format json
sweep emu.osim --grid stiffness=x0.1..x10/200 --grid dissipation=0.1..2/200 -d out --dry-run
sweep radii.osim --grid indentation=0.1 --spheres 2
sweep sideless.osim --grid indentation=0.1
sweep sideless.osim --grid stiffness=x2
sweep weightless.osim --grid stiffness=x2
sweep ball.osim --grid stiffness=x2 --select contact_*
sweep materials.osim --grid stiffness=x2,3e6
sweep emu2.osim --grid hertz_smoothing=300
sweep emu.osim --grid stiffness=x1,x2,x3 -d out --point 2 && sweep emu.osim --grid stiffness=x1,x2,x3 -d out --resume
sweep emu.osim --grid stiffness=x1,x2,x3 -d out --shard 1/2 && sweep emu.osim --grid stiffness=x1,x2,x3 -d out --shard 2/2 --format json
sweep emu.osim --grid stiffness=x1,x2,x3 -d out --shard 5/8
sweep emu.osim --grid stiffness=x1,x2,x3 -d out --point 4
sweep emu.osim --grid stiffness=x1,x2,x3 -d out --point 1 --shard 1/2
:copy emu.osim lib2/emu.osim && sweep lib2/emu.osim --grid stiffness=x1,x2 && lib2 --target-mass 5 -d out
:put out/emu_2_stiffness-x2.osim mine && sweep emu.osim --grid stiffness=x1,x2 -d out
:put out mine && sweep emu.osim --grid stiffness=x1,x2 -d out
sweep emu.osim --grid stiffness=x1,x2 -d out > full
FILE_LIMIT=8192 sweep emu.osim --grid stiffness=x1,x2 -d out --jobs 1
sweep include.osim --grid stiffness=x2
sweep file_both_sets.osim --grid radius=x2
:link ../emu.osim out/emu_1_stiffness-x2.osim && sweep emu.osim --grid stiffness=x2 -d out --force
:copy emu.osim a_1_stiffness-x2.osim && :copy emu.osim a.osim && sweep a.osim --grid stiffness=x2 -d . && sweep a.osim --grid stiffness=x2 -d . --force
sweep forces.xml --grid stiffness=x2
sweep massless.osim --grid target-mass=5
sweep massless.osim --grid indentation=0.1 --spheres 2
sweep zero.osim --grid stiffness=x2,3e6
"""

PLOTS = r"""
plot force falisse2022 -o force.svg
plot force falisse2022 -o -
plot force falisse2022 --target-mass 1190 -o -
plot force falisse2022 --target-mass 1190 --axes real -o figure.svg
plot state falisse2022 -o -
plot loop falisse2022 -o -
plot loop falisse2022 mouse.osim -o -
plot drop rat.osim hunt.osim --stance-limbs 2 -o drop.svg
plot drop falisse2022 --target-mass 0.02 -o -
plot drop falisse2022 --gravity 1.62 --duration 3 --height 0.1 -o -
plot sweep falisse2022 --quantity indentation -o -
plot sweep falisse2022 --quantity peak-force -o -
plot sweep falisse2022 --quantity restitution --stiffness x0.1..x10/9 --dissipation 0.1..10/41 -o figure.svg
plot sweep falisse2022 --target-mass 1190 -o -
plot fig4 -o fig4.svg
plot fig4 -o -
plot fig-c5 -o -
plot fig-c5 -o fig.png --dpi 100
plot fig4 -o fig.png --dpi 60
plot force falisse2022 -o force.png --dpi 150
plot drop human.osim mouse.osim -o drop.png --dpi 100
plot sweep falisse2022 -o sweep.png --dpi 80
plot state human.osim -o state.PNG --dpi 72
plot loop human.osim -o loop.png --dpi 72 && plot loop human.osim -o loop.png --dpi 72 --force
plot force falisse2022 -o figure.pdf
plot force falisse2022 -o figure
plot force falisse2022 -o ''
plot force human.osim
plot force -o figure.svg
plot
plot force
plot cake human.osim -o figure.svg
plot force nobody1900 -o figure.svg
plot fig4 human.osim -o figure.svg
plot fig-c5 falisse2022 -o figure.svg
plot sweep human.osim -o figure.svg --stiffness 1..2
plot sweep human.osim -o figure.svg --stiffness x1..2/5
plot sweep human.osim -o figure.svg --stiffness 2..1/5
plot sweep human.osim -o figure.svg --dissipation 1..2/500
plot force human.osim -o figure.svg --dpi 10
plot force human.osim -o figure.svg --dpi many
plot force human.osim -o figure.svg --axes none
plot force human.osim -o out/deep/figure.svg
:put force.svg mine && plot force falisse2022 -o force.svg && plot force falisse2022 -o force.svg --force
:copy human.osim human.svg && plot force ./human.svg -o human.svg --force
:mkdir figure.svg && plot force human.osim -o figure.svg --force
plot force truncated.osim -o figure.svg
plot force missing.osim -o figure.svg
plot force lib -o figure.svg
plot state rat.osim -o figure.svg
plot sweep elastic.osim -o figure.svg
plot sweep radii.osim --spheres 2 -o figure.svg
plot sweep human.osim mouse.osim -o figure.svg
plot force weightless.osim -o figure.svg
plot drop weightless.osim -o drop.svg
plot force radii.osim --spheres 2 -o -
plot force human.osim mouse.osim horse.osim giraffe.osim emu.osim --stance-limbs 1 -o -
plot force human.osim human.osim -o -
plot force human.osim falisse2022 lab_heel --presets both.toml -o -
plot force ball.osim -o -
plot force ball.osim --select ball_floor --spheres 1 -o -
plot force human.osim --title '' -o -
plot force human.osim --title 'Größe <1> & "two"' -o -
plot drop human.osim --height 8mm -o -
plot drop human.osim --duration 0 -o -
plot force human.osim --target-mass 20kg -o -
plot loop elastic.osim --spheres 2 -o -
plot force mixed.osim materials.osim --spheres 2 --mass 70 -o -
plot loop human.osim --height 0.02 -o -
plot loop human.osim --height 0 -o -
plot sweep falisse2022 --stiffness 1e-3..1e3/5 --dissipation 1e-4..1/4 -o -
plot sweep falisse2022 --quantity peak-force --stiffness 1e2..1e10/4 --dissipation x0.1..x9/4 -o -
plot force human.osim hunt.osim heavy.osim mouse.osim rat.osim emu.osim emu2.osim horse.osim giraffe.osim model.osim other.osim foot.osim --spheres 2 --mass 70 -o -
plot force unlike.osim radii.osim mixed.osim materials.osim human.osim mouse.osim --spheres 2 --mass 70 -o -
plot state human.osim mouse.osim --target-mass 5 -o -
plot drop giraffe.osim --stance-limbs 2 --target-mass 1e-6 -o -
"""

FIT = r"""
fit heel.csv --radius 0.03 --indentation-unit mm --time-column time --onset fit
fit heel.csv --radius 0.03 --indentation-unit mm --time-column time --onset fit --format json
fit heel.csv --radius 0.03 --indentation-unit mm
fit heel.csv --radius 0.03 --indentation-unit mm --onset 0.00035 --branch loading --time-column time
fit heel_eu.csv --radius 0.03 --indentation-column Eindringtiefe --indentation-unit mm --force-column Kraft --force-unit kN --time-column Zeit --onset fit
fit heel_eu.csv --radius 0.03 --indentation-column eindringtiefe --force-column KRAFT
fit curve.csv --radius 0.01 --onset 0.0005
fit curve.csv --radius 0.032 --spheres 6 --onset fit --speed-column speed
fit curve.csv --radius 0.032 --onset 0.0005 --branch unloading --format json
fit curve_eu.csv --radius 0.032 --spheres 6 --onset fit --indentation-unit mm --force-unit kN --speed-unit mm/s --speed-column speed --format json
fit curve_micro.csv --radius 0.032 --spheres 6 --onset fit --speed-column speed --indentation-unit um --force-unit mN --format json
fit curve_ms.csv --radius 0.032 --spheres 6 --onset 0.0005 --time-column time --time-unit ms --format json
fit curve.csv --radius 0.032 --onset -0.001
fit curve.csv --radius 0.032 --onset 1
fit curve.csv
fit
fit curve.csv heel.csv --radius 0.03
fit curve.csv --radius 0.032 --onset late
fit curve.csv --radius 0.032 --speed-column speed --time-column time
fit curve.csv --radius 0.032 --force-unit lbf
fit curve.csv --radius 0.032 --speed-column velocity
fit curve.csv --radius 32mm
fit curve.csv --radius 0
fit curve.csv --radius 0.032 --spheres 0
fit curve.csv --radius 0.032 --format csv
fit nowhere.csv --radius 0.03
fit lib --radius 0.03
fit human.osim --radius 0.03
fit - --radius 0.03
:put wide.csv '\xff\xfei\x00n\x00' && fit wide.csv --radius 0.03
fit fit_word.csv --radius 0.03 --format json
fit curve_fast.csv --radius 0.032 --onset 0.0005 --speed-column speed
fit curve_fast.csv --radius 0.032 --onset fit --time-column time --format json
fit curve.csv --radius 0.032 --onset 0.0005 --speed-column speed --branch unloading
fit curve.csv --radius 0.032 --onset 0.0005 --speed-column speed --branch loading --format json
fit sep.csv --radius 0.03
fit column_twice.csv --radius 0.03
fit fit_huge.csv --radius 0.03 --onset fit
fit curve.csv --radius 1e-9 --onset fit
"""
