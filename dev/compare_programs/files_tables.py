"""Tables of calls about files, folders and standalone sets; one call a line, in the language of `calls.py`."""

# Where results go, and what is never lost.
FILES = r"""
human.osim --target-mass 1190 && human.osim --target-mass 1190 && human.osim --target-mass 500 --force
human.osim --target-mass 500 --dry-run --force
:put human.osim.bak precious && human.osim --target-mass 1190 --in-place && human.osim --target-mass 500 --in-place && human.osim --target-mass 100 --in-place --no-backup
:mkdir store && :copy human.osim store/real.osim && :rm human.osim && :link store/real.osim human.osim && human.osim --target-mass 1190 --in-place
:link human.osim link.osim && human.osim --target-mass 1190 -o link.osim --force
:link nowhere.osim dangling.osim && human.osim --target-mass 1190 -o dangling.osim
:link nowhere.osim dangling.osim && human.osim --target-mass 1190 -o dangling.osim --force
:link nowhere.osim dangling.osim && inspect dangling.osim
:chmod 640 human.osim && human.osim --target-mass 1190 -o out.osim && human.osim --target-mass 1190 --in-place
:chmod 444 human.osim && human.osim --target-mass 1190 && human.osim --target-mass 1190 --in-place
:put out.osim old && :chmod 604 out.osim && human.osim --target-mass 2000 -o out.osim --force
- --target-mass 1190 < human.osim
- --target-mass 1190 -o other.osim --force < human.osim
- --target-mass 1190 -o - --quiet < human.osim
- --target-mass 1190 --format json < human.osim
- --target-mass 1190 --diff < human.osim
- --target-mass 1190 --dry-run --diff --format json < human.osim
- --target-mass 1190 -d out < human.osim
- --target-mass 5 --in-place < human.osim
- - --target-mass 5 < human.osim
- human.osim --target-mass 5 < human.osim
- human.osim --target-mass 5 -d out < human.osim
- --target-mass 1190
- < human.osim
inspect - < human.osim
inspect - -
check - --format json < human.osim
drop-test - < human.osim
plot force - -o - < human.osim
sweep - --grid stiffness=x2 < human.osim
transfer - --from - --spheres 2 < human.osim
transfer human.osim --from - --spheres 2 --dry-run < mouse.osim
set - stiffness=x2 -o out.osim < human.osim
human.osim --target-mass 1190 -o - && human.osim --target-mass 1190 -o - --quiet
human.osim --target-mass 1190 -o - > full
human.osim --target-mass 1190 -o - > closed
human.osim --target-mass 1190 > full
human.osim --target-mass 1190 > closed
inspect human.osim --format json > closed
inspect human.osim > full
check human.osim > full
explain > closed
explain > full
--help > closed
--version > full
presets > full
fit curve.csv --radius 0.03 > full
drop-test human.osim --format csv > full
plot force falisse2022 -o - > full
plot force falisse2022 -o - > closed
design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 > full
dozen --target-mass 500 -d out --format json > full
dozen --target-mass 500 -d out --format table > closed
:put F_human.scaled.so compiled && human.osim --target-mass 1190
:put F_human.dll compiled && human.osim --target-mass 1190 --in-place
:put F_human2.dll compiled && human.osim --target-mass 1190 --in-place
:put F_human.so compiled && check human.osim && inspect human.osim --format json
human.osim --target-mass 5 -o out/deep/er.osim && human.osim --target-mass 7 -o out/deep/er.osim
:mkdir folder.osim && human.osim --target-mass 5 -o folder.osim
:mkdir folder.osim && inspect folder.osim
:put taken.osim precious && human.osim --target-mass 5 -o taken.osim
:put taken.osim precious && human.osim --target-mass 5 -d taken.osim
:put taken precious && human.osim --target-mass 5 -o taken/x.osim
human.osim --target-mass 5 -o human.osim
human.osim --target-mass 5 -o ./human.osim --force
human.osim --target-mass 5 -d .
human.osim --target-mass 5 -d . --force
human.osim --target-mass 5 -o ''
human.osim --target-mass 5 -d ''
'' --target-mass 5
:mkdir locked && :copy human.osim locked/a.osim && :chmod 555 locked && locked/a.osim --target-mass 5
:mkdir out && :chmod 555 out && human.osim --target-mass 5 -d out
:chmod 000 human.osim && inspect human.osim
model.osim ./model.osim --target-mass 424 --in-place
model.osim . --target-mass 424 --in-place
model.osim model.osim --target-mass 424 --in-place
model.osim human.osim --target-mass 5 -o out.osim
right/foot.osim left/foot.osim --target-mass 5 -d out
left/foot.osim right/FOOT.osim left/more.osim --target-mass 5 -d out
left right --target-mass 5 -d out
human.osim --target-mass 1190 -o a.osim && a.osim --target-mass 500 -o b.osim && b.osim --target-mass 500 --in-place && b.osim --target-mass 62 -o c.osim
human.osim --target-mass 62 -o copy.osim && human.osim --target-mass 62 -d out && human.osim --target-mass 62 -o -
human.osim --target-mass 62.05 && human.osim --target-mass 62.07
human.osim --target-mass 100 --radius keep --only dissipation -o same.osim
giraffe.osim --target-mass 1190
giraffe.osim --target-mass 1190 --contacts-mass 62 -o out.osim
giraffe.osim --target-mass 500 --contacts-mass 62 --dry-run
human.osim --target-mass 1190 --only stiffness -o part.osim && part.osim --target-mass 500 && part.osim --target-mass 500 --contacts-mass 1190
human.osim --target-mass 1190 --keep dissipation -o part.osim && part.osim --target-mass 500 && check part.osim && inspect part.osim
human.osim --target-mass 1190 --select *_r* -o part.osim && part.osim --target-mass 500 --format json
human.osim --target-mass 1190 --keep radius -o kept.osim && inspect kept.osim --format json
human.osim --target-mass 1190 -o a.osim && :once a.osim <dissipation>1.2 <dissipation>1.3 && a.osim --target-mass 500 && check a.osim && a.osim --target-mass 500 --contacts-mass 1190
human.osim --target-mass 1190 -o a.osim && :once a.osim <mass>42.0390625 <mass>43 && a.osim --target-mass 500
human.osim --target-mass 1190 --no-note -o a.osim && a.osim --target-mass 62 && a.osim --target-mass 500 --no-note -o b.osim
human.osim --target-mass 1190 -o a.osim && a.osim --target-mass 500 --no-note -o b.osim && b.osim --target-mass 100
human.osim --target-mass 1190 -o a.osim && a.osim --target-mass 70 --target-gravity 1.62 -o b.osim && b.osim --target-mass 100 -o c.osim && inspect c.osim --format json
set human.osim stiffness=x2 --in-place --no-backup && set human.osim stiffness=x2 --in-place --no-backup && set human.osim stiffness=x2 --in-place --no-backup --force && set human.osim stiffness=5e6 --in-place --no-backup && human.osim --target-mass 500
set human.osim dissipation=1 -o out.osim && out.osim --target-mass 500 && out.osim --target-mass 500 --contacts-mass 62
set human.osim stiffness=x2 --in-place && set human.osim stiffness=x2 --in-place --format json && set human.osim stiffness=x3 --in-place
design human.osim --indentation 0.16 -o out.osim && drop-test out.osim --format json --samples 5 && out.osim --target-mass 500
human.osim --target-mass 0.0209 && check human.scaled.osim && check human.scaled.osim --mass 0.0209 && drop-test human.scaled.osim && plot force human.scaled.osim -o figure.svg && drop-test human.scaled.osim --mass 0.0209
:copy human.osim 'my model.osim' && check 'my model.osim' --spheres 2 --mass 80 --exclude 'contact_s1_*' --format json && 'my model.osim' --target-mass 5 --report page.html
:copy human.osim a&b.osim && :once a&b.osim '<Model name="' '<Model name="&lt;script&gt;alert(1)&lt;/script&gt;' && inspect a&b.osim --report page.html && a&b.osim --target-mass 5
:copy human.osim -x.osim && inspect -- -x.osim && inspect ./-x.osim && inspect -x.osim
:copy human.osim größe.osim && größe.osim --target-mass 5 --format json --summary s.csv
:copy human.osim "it's.osim" && check "it's.osim" && "it's.osim" --target-mass 500 -d "o'ut" --report page.html
:put page.html mine && human.osim --target-mass 1190 --report page.html && inspect human.osim --report page.html && check human.osim --report page.html && inspect human.osim --report page.html --force
human.osim --target-mass 90 --force --report human.osim
check human.osim --report page.txt
check human.osim --report out/deep/page.html
inspect human.osim --report page.HTML
inspect human.osim --report -
:copy human.osim model.html && inspect model.html --force --report model.html && model.html --target-mass 90 --force --report model.html && inspect human.osim --from model.html --force --report model.html
human.osim --target-mass 90 -o out.html --report out.html
human.osim --target-mass 90 --report page.html --dry-run
human.osim --target-mass 90 --report page.html && human.osim --target-mass 90 --report page.html --force
human.osim --target-mass 1190 --target-gravity 1.62 --report page.html
include.osim --target-mass 100
include.osim --target-mass 5 --only radius -d out
include.osim --target-mass 5 --only radius
inspect include.osim --report page.html
sweep include.osim --grid radius=x2 -d out
CLICOLOR_FORCE=1 NO_COLOR= human.osim --target-mass 1190 --dry-run --diff
CLICOLOR_FORCE=1 NO_COLOR= inspect human.osim
CLICOLOR_FORCE=1 NO_COLOR= check sunk.osim lib
CLICOLOR_FORCE=1 NO_COLOR= drop-test human.osim
COLUMNS=40 inspect human.osim
COLUMNS=200 check floats.osim
COLUMNS=60 human.osim --target-mass 1190 --diff
COLUMNS= inspect emu2.osim
LC_ALL=C explain C.5
LC_ALL=C TERM=linux inspect human.osim
:copy human.osim sub/a.osim && sub/../sub/a.osim --target-mass 5 -o sub/../out.osim
human.osim --target-mass 5 -o ../out.osim && inspect ../out.osim
human.osim --target-mass 5 -d ../out && human.osim --target-mass 5 -o nowhere/../human.osim --force
human.osim --target-mass 5 -o ./nowhere/./out.osim
:pipe out.osim && human.osim --target-mass 5 -o out.osim --force
:pipe out.svg && plot force falisse2022 -o out.svg --force
human.osim --target-mass 500 --radius x1.5 --in-place && human.osim --target-mass 1000 --radius x1.5 --in-place && human.osim --target-mass 500 --radius x1.5 --in-place --contacts-mass 62
design human.osim --radius x1.25 --in-place && design human.osim --radius x1.25 --in-place && design human.osim --radius x1.25 --in-place --force
human.osim --target-mass 500 --only static_friction
human.osim --target-mass 500 --only radius --keep radius
human.osim --target-mass 1,190
weightless.osim --target-mass 500 --target-gravity 1.62
transfer weightless.osim --from falisse2022 --spheres 2 --target-gravity 1.62
human.osim --target-mass 1190 --target-gravity 1.62 -o a.osim && :once a.osim <dissipation> <dissipation>1 && a.osim --target-mass 500 --target-gravity 9.81 --contacts-mass 1190
:edit model.osim <gravity> <gravity>a && inspect model.osim && check model.osim && model.osim --target-mass 5 --target-gravity 3
scaled.osim --target-mass 500 --level --level-axis x
scaled.osim --target-mass 500 --level --level-axis y --diff
scaled.osim --target-mass 500 --level --level-axis -z --format json
scaled.osim --target-mass 500 --level --level-axis w
inspect - --report page.html < human.osim
check - --report page.html --format json < sunk.osim
- --target-mass 500 -o out.osim --report page.html < human.osim
:put empty_root.osim '<OpenSimDocument Version="40000"></OpenSimDocument>' && inspect empty_root.osim && empty_root.osim --target-mass 5
:put end.osim '</OpenSimDocument>' && inspect end.osim
:put stray.osim 'text<OpenSimDocument Version="40000"/>' && inspect stray.osim
:put amp.osim '<OpenSimDocument Version="40000"><Model name="a&b"/></OpenSimDocument>' && inspect amp.osim
:put nested.osim '<OpenSimDocument Version="40000"><Model><OpenSimDocument/></Model></OpenSimDocument>' && check nested.osim
:edit frame_on_frame.osim ../sole ../insole && inspect frame_on_frame.osim
:edit frame_on_frame.osim ../sole ../nothing && inspect frame_on_frame.osim
:edit frame_on_frame.osim <socket_parent>../sole</socket_parent> '' && inspect frame_on_frame.osim
drop-test human.osim > terminal
drop-test falisse2022 --duration 0.5 > terminal
inspect human.osim > terminal
check sunk.osim > terminal
NO_COLOR= TERM=xterm inspect mixed.osim > terminal
NO_COLOR= TERM=xterm check floats.osim lib > terminal
NO_COLOR= TERM=xterm human.osim --target-mass 1190 --dry-run --diff > terminal
NO_COLOR= TERM=xterm drop-test human.osim > terminal
NO_COLOR= TERM=xterm --help > terminal
LC_ALL=C NO_COLOR= TERM=linux explain C.5 > terminal
LC_ALL=C TERM=linux explain C.5 > terminal
COLUMNS= inspect human.osim > terminal
human.osim --target-mass 1190 -o - > terminal
plot force falisse2022 -o - > terminal
inspect human.osim model.osim > closed
check human.osim model.osim > closed
human.osim model.osim --target-mass 500 --dry-run > closed
human.osim model.osim --target-mass 500 -d out --format json > full
batch masses.csv --dry-run --report page.html
batch failing.csv --dry-run --report page.html
"""

# Folders, summaries and what interrupts them.
LIBRARIES = r"""
lib --target-mass 100 -d out
lib --target-mass 100 -d out --report page.html && lib --target-mass 100 -d out --report page.html --force --jobs 4
lib --target-mass 100 -d out --summary done.csv --report page.html && lib --target-mass 100 -d out --summary done.csv --report page.html --resume
lib --target-mass 100 --in-place --summary done.csv --report page.html && lib --target-mass 100 --in-place --summary done.csv --report page.html --resume
lib --target-mass 100 --in-place --format lines --no-note
lib --target-mass 100 -d out --format json --diff
lib --target-mass 100 -d out --dry-run --summary s.ndjson
lib
lib --format json
inspect lib
inspect lib --format json
inspect lib --format csv
inspect lib --report page.html
inspect lib dozen --report page.html --quiet
check lib
check lib --format csv
check lib --format json
check lib --report page.html
check lib --deny warn
check dozen --report page.html
check pair shape lib
check lib/c_none.osim
transfer lib --from falisse2022 --spheres 6 -d out --report page.html
transfer lib --from lib --spheres 6 -d out
design lib --indentation 0.16 -d out --summary s.csv
set lib stiffness=x2 -d out --format lines
shape --target-mass 492 -d out
shape --target-mass 492 -d shape/out && shape --target-mass 492 -d shape/out --force
shape --target-mass 492 && shape --target-mass 492 --force
shape --target-mass 492 --in-place --quiet
inspect shape
dozen --target-mass 500 -d out
dozen --target-mass 500 -d out --format table
dozen --target-mass 500 -d out --format lines --diff
dozen --target-mass 500 -d out --jobs 1 --summary s.csv
dozen --target-mass 500 -d out --jobs 8 --summary s.csv
dozen --target-mass 500 -d out --report page.html
dozen --target-mass 500 --dry-run
dozen --target-mass 500 -d out --quiet --summary s.ndjson --no-note
dozen --target-mass 500 -d out --summary done.txt
thirty --target-mass 500 -d out --shard 1/3 --summary 1.csv && thirty --target-mass 500 -d out --shard 2/3 --summary 2.csv && thirty --target-mass 500 -d out --shard 3/3 --summary 3.csv
thirty --target-mass 500 -d out --shard 1/7 --format table
thirty --target-mass 500 -d out --shard 7/7 --format json --summary s.ndjson
thirty --target-mass 500 -d out --shard 1/1
:put thirty/even/broken.osim <OpenSimDocument> && :copy none.osim thirty/odd/none.osim && thirty --target-mass 500 -d out --format json --summary s.csv --jobs 8
five --target-mass 500 -d out --shard 0/4
five --target-mass 500 -d out --shard 5/4
five --target-mass 500 -d out --shard one/two
five --target-mass 500 -d out --shard 1/0
five --target-mass 500 -d out --shard 1
five --target-mass 500 -d out --summary done.csv && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && :copy horse.osim five/odd/model03.osim && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && five --target-mass 600 -d out --summary done.csv --resume && five --target-mass 600 -d out --summary done.csv --no-note --resume && five --target-mass 600 -d out --summary done.csv --no-note --resume --jobs 1 --format json
transfer five --from human.osim --spheres 2 -d out --summary done.ndjson && transfer five --from human.osim --spheres 2 -d out --summary done.ndjson --resume && :copy emu.osim human.osim && transfer five --from human.osim --spheres 2 -d out --summary done.ndjson --resume
five --target-mass 500 -d out --summary done.csv && :rm out/even/model02.osim && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && :put out/even/model02.osim mine && five --target-mass 500 -d out --summary done.csv --resume && :copy emu.osim five/even/model02.osim && five --target-mass 500 -d out --summary done.csv --resume && five --target-mass 500 -d out --summary done.csv --resume --force
:put five/odd/model01.osim <OpenSimDocument> && five --target-mass 500 -d out --summary done.csv && :copy human.osim five/odd/model01.osim && five --target-mass 500 -d out --summary done.csv --resume
set five stiffness=x2 --in-place --no-backup --summary done.csv && set five stiffness=x2 --in-place --no-backup --summary done.csv --resume
forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 -d out --summary done.csv && :rm out/geometry.xml && forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 -d out --summary done.csv --resume && :put out/geometry.xml mine && forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 -d out --summary done.csv --resume
:put done.csv 'frame,radius\n1,0.03\n' && five --target-mass 500 -d out --summary done.csv --resume && five --target-mass 500 -d out --summary done.csv
:put done.csv 'model,status\nfive/a.osim,written\n' && five --target-mass 500 -d out --summary done.csv --resume
:put done.csv notes && five --target-mass 500 -d out --summary done.csv --resume
:put done.csv '' && five --target-mass 500 -d out --summary done.csv --resume
:put done.ndjson '{"frame": 1}\n' && five --target-mass 500 -d out --summary done.ndjson --resume && five --target-mass 500 -d out --summary done.ndjson
:put done.ndjson '[1, 2]\n' && five --target-mass 500 -d out --summary done.ndjson --resume
:put done.ndjson notes && five --target-mass 500 -d out --summary done.ndjson --resume
five --target-mass 500 -d out --summary done.csv && :cut done.csv 30 && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.ndjson && :cut done.ndjson 30 && five --target-mass 500 -d out --summary done.ndjson --resume
five --target-mass 500 -d out --summary done.csv && :edit done.csv , ; && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && :edit done.csv written writ && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && :edit done.csv written failed && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && :copy done.csv done.csv.partial && :rm done.csv && :rm out/odd && five --target-mass 500 -d out --summary done.csv --resume
five --target-mass 500 -d out --summary done.csv && :copy done.csv done.csv.partial && :rm done.csv && :cut done.csv.partial 40 && five --target-mass 500 -d out --summary done.csv --resume
:put done.csv.partial '' && five --target-mass 500 -d out --summary done.csv && five --target-mass 500 -d out --summary done.csv --force
transfer five --from human.osim -d out --summary human.osim --force
five/even/model00.osim --target-mass 500 -o x.csv --summary x.csv --force
five --target-mass 500 -d out --summary out/even/model00.osim
five --target-mass 500 -d out --resume
five --target-mass 500 -d out --summary done.csv --resume --dry-run
five --target-mass 500 -d out --summary nowhere/deep/done.csv
:mkdir done.csv && five --target-mass 500 -d out --summary done.csv
batch outputs.csv --summary done.csv && :put outputs.csv 'model,target-mass,output\nhuman.osim,70,c.osim\nhuman.osim,5,a.osim\nhuman.osim,500,b.osim\n' && batch outputs.csv --summary done.csv --resume
:link gone.osim five/dead.osim && :link gone five/dead_folder && :link gone.mot five/motion.mot && :link .. five/odd/up && five --target-mass 500 -d out --summary done.csv
:link gone.osim five/dead.osim && :link .. five/odd/up && check five
:pipe five/pipe.osim && five --target-mass 500 -d out --summary done.csv
five --target-mass 500 -d five/out --summary five/done.csv && five --target-mass 500 -d five/out --summary five/done.csv --resume
:copy model.osim five/even/MODEL00.osim && five --target-mass 500 -d out
five dozen --target-mass 500 -d out
five ./five five/even --target-mass 500 -d out
:mkdir links && :link ../five/even/model00.osim links/a.osim && :link ../five/even links/b && set links five stiffness=x2 --in-place --no-note
:hard five/even/model00.osim five/even/second.osim && set five stiffness=x2 --in-place --no-note --no-backup --jobs 1
:mkdir empty && empty --target-mass 100 && inspect empty && check empty && transfer empty --from falisse2022
:mkdir empty && empty lib --target-mass 100 -d out
nowhere --target-mass 100 -d out
nowhere.osim human.osim nowhere2.osim --target-mass 100 -d out --format json
comma.osim truncated.osim nowhere.osim model.osim --target-mass 123 --format json
comma.osim truncated.osim nowhere.osim model.osim --target-mass 123 --summary s.csv
inspect comma.osim truncated.osim nowhere.osim model.osim --format json
check comma.osim truncated.osim nowhere.osim model.osim
FILE_LIMIT=16384 five --target-mass 500 -d out --summary done.csv --jobs 1 && five --target-mass 500 -d out --summary done.csv --resume
FILE_LIMIT=16384 human.osim --target-mass 5 --in-place
FILE_LIMIT=4096 inspect human.osim --report page.html
FILE_LIMIT=4096 plot force falisse2022 -o figure.svg
FILE_LIMIT=100 human.osim --target-mass 5 --dry-run --summary s.csv
:put out/even/.osim-contact-scale-@HOST@-4194399-a1B2c3.tmp half && :put out/odd/.osim-contact-scale-elsewhere-4194399-a1B2c3.tmp half && :put out/.osim-contact-scale-of-mine.tmp half && five --target-mass 500 -d out --dry-run && five --target-mass 500 -d out
:put .osim-contact-scale-@HOST@-4194399-a1B2c3.tmp half && human.osim --target-mass 5
:put .osim-contact-scale-@HOST@-4194399-a1B2c3.tmp half && inspect human.osim && sweep human.osim --grid stiffness=x2
:copy human.osim a.osim.sweep/x.osim && :copy model.osim lib2/a.osim && :copy model.osim lib2/b.sweep/c.osim && lib2 --target-mass 500 -d out
check thousand --report page.html --quiet
check thousand --report page.html
thousand --target-mass 500 -d out --summary s.ndjson --report page.html
inspect thousand --format csv
:pipe pipe.osim && STOP=pipe.osim:human.osim pipe.osim five --target-mass 500 -d out --jobs 1
:pipe pipe.osim && STOP=pipe.osim:human.osim pipe.osim five --target-mass 500 -d out --jobs 1 --summary done.csv && :copy human.osim pipe.osim && pipe.osim five --target-mass 500 -d out --jobs 1 --summary done.csv --resume
:pipe pipe.osim && STOP=pipe.osim:human.osim pipe.osim five --target-mass 500 -d out --jobs 1 --summary done.ndjson --format json --report page.html
:pipe pipe.osim && STOP=pipe.osim:truncated.osim pipe.osim five --target-mass 500 --in-place --jobs 1 --summary done.csv
:pipe pipe.osim && FEED=pipe.osim:human.osim pipe.osim --target-mass 500 -o out.osim
:pipe pipe.osim && FEED=pipe.osim:human.osim inspect pipe.osim --format json
:pipe pipe.osim && FEED=pipe.osim:human.osim pipe.osim --target-mass 500 --in-place
:pipe pipe.osim && FEED=pipe.osim:mouse.osim transfer human.osim --from pipe.osim --reference-spheres 2 --dry-run
:pipe pipe.osim && STOP=pipe.osim:emu.osim sweep pipe.osim --grid stiffness=x1,x2 -d out --jobs 1
:pipe pipe.osim && STOP=pipe.osim:emu.osim inspect pipe.osim five
:pipe pipe.osim && STOP=pipe.osim:emu.osim pipe.osim --target-mass 500 -d out
"""

# A force set and its geometry in files of their own.
SETS = r"""
forces.xml --geometry geometry.xml --model bones.osim --target-mass 492
forces.xml --geometry geometry.xml --model bones.osim --target-mass 492 --dry-run --diff
forces.xml --geometry geometry.xml --model bones.osim --target-mass 492 --format json
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 -o f.xml --geometry-output g.xml && f.xml --geometry g.xml --target-mass 61.5 -d back && f.xml --geometry geometry.xml --target-mass 100 -d mixed
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 --in-place
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 --in-place --no-backup --no-note
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 -o - --geometry-output g.xml
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 -o -
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 -o f.xml --geometry-output f.xml
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 --geometry-output geometry.xml --force
:put geometry.scaled.xml precious && forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492
forces.xml --geometry geometry.xml --model bones.osim --target-mass 200 -d out --report page.html && check out/forces.xml --geometry geometry.xml --model bones.osim && inspect out/forces.xml --geometry out/geometry.xml --model bones.osim
inspect forces.xml --geometry geometry.xml --model bones.osim --report look.html
inspect forces.xml --geometry geometry.xml
check forces.xml --geometry geometry.xml --format json
check forces.xml --geometry geometry.xml --model bones.osim
drop-test forces.xml --geometry geometry.xml --model bones.osim --spheres 1
plot force forces.xml --geometry geometry.xml --model bones.osim --spheres 1 -o -
design forces.xml --geometry geometry.xml --model bones.osim --indentation 0.16 --spheres 1 -d out
transfer forces.xml --geometry geometry.xml --model bones.osim --from falisse2022 --spheres 1 -d out
set forces.xml stiffness=x2 radius=0.05 --geometry geometry.xml -d out
set forces.xml stiffness=x2
forces.xml --target-mass 100
geometry.xml --target-mass 100
forces.xml --geometry geometry.xml --target-mass 100
forces.xml --geometry nowhere.xml --target-mass 100
forces.xml --geometry geometry.xml --model nowhere.osim --target-mass 100
forces.xml --geometry forces.xml --target-mass 100
forces.xml --geometry human.osim --model human.osim --target-mass 100 --dry-run
human.osim --geometry geometry.xml --target-mass 100
human.osim --model bones.osim --target-mass 100
human.osim --geometry-output g.xml --target-mass 100
forces.xml human.osim --geometry geometry.xml --target-mass 100
forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 --level --dry-run
forces.xml --geometry geometry.xml --model bones.osim --target-mass 492 --level -d out
standalone_defaults_ForceSet.xml --geometry geometry.xml --model bones.osim --target-mass 492
inspect standalone_defaults_ForceSet.xml --geometry geometry.xml --model bones.osim --format json
- --geometry geometry.xml --model bones.osim --target-mass 492 < forces.xml
batch sets.csv --summary s.csv
v40600_moco_3d_walking_ContactForceSet.xml --geometry v40600_moco_3d_walking_ContactGeometrySet.xml --model v40600_moco_3d_walking_model_without_contacts.osim --target-mass 100
inspect v40600_moco_3d_walking_ContactForceSet.xml --geometry v40600_moco_3d_walking_ContactGeometrySet.xml --model v40600_moco_3d_walking_model_without_contacts.osim
check v40600_moco_3d_walking_ContactForceSet.xml --geometry v40600_moco_3d_walking_ContactGeometrySet.xml --model v40600_moco_3d_walking_model_without_contacts.osim --format json
transfer v40600_moco_3d_walking_ContactForceSet.xml --geometry v40600_moco_3d_walking_ContactGeometrySet.xml --model v40600_moco_3d_walking_model_without_contacts.osim --from falisse2022 --level --radius isometric -d out --report page.html
"""
