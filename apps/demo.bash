# What './carina demo' does. Part of ./carina, which sources it.
# shellcheck shell=bash disable=SC2154 # root and build are the launcher's

free_port() {
    python3 -c 'import socket; probe = socket.socket(type=socket.SOCK_DGRAM)
probe.bind(("127.0.0.1", 0)); print(probe.getsockname()[1])'
}

children=()
end_children() {
    trap - INT TERM
    [ ${#children[@]} = 0 ] || kill "${children[@]}" 2> /dev/null || true
    wait || true
}

# Waits for every child; the first that fails ends the others, and its status is the result.
wait_for_children() {
    local ended status
    while [ ${#children[@]} -gt 0 ]; do
        status=0
        wait -n -p ended "${children[@]}" || status=$?
        mapfile -t children < <(printf '%s\n' "${children[@]}" | grep -vx "$ended")
        if [ $status != 0 ]; then
            end_children
            return $status
        fi
    done
}

demo_folder() { echo "${XDG_DATA_HOME:-$HOME/.local/share}/carina/demo"; }

# begin_site DIR: the file that the wizard is going to make; one from before is kept beside it.
begin_site() {
    mkdir -p "$1" 2> /dev/null || die "cannot write into $1"
    site=$1/site.json
    [ ! -e "$site" ] || mv "$site" "$1/site-before.json"
}

# demo_windows PORT: all programs on the display there is.
demo_windows() {
    local port=$1 data
    data=$(demo_folder)
    mkdir -p "$data"
    if [ "$register" = yes ]; then
        say "registering; close the wizard when it has fitted the patient"
        "$build/apps/registration/carina-registration" --tracker "$tracker" --site "$site" \
            "${patient[@]}"
    fi
    rm -f "$data/codes"
    "$build/apps/instructor/carina-instructor" --port "$port" --data "$data" --new \
        --codes "$data/codes" ${intubation:+--start} "${play[@]}" \
        "${patient[@]}" &
    children+=($!)
    "$build/apps/trainee/carina-trainee" --port "$port" --as Trainee --tracker "$tracker" \
        --data "$data" --code-file "$data/codes" "${patient[@]}" "${view[@]}" &
    children+=($!)
    wait_for_children
}

# register_headless DIR SIZE: the wizard, worked by a scripted technician.
register_headless() {
    local out=$1 size=$2
    rm -f "$out"/registration*
    if ! with_display timeout --kill-after=10 240 "$build/apps/registration/carina-registration" \
        --tracker simulated --site "$site" --measure "$out" --size "$size" "${patient[@]}" \
        > "$out/registration.log" 2>&1; then
        tail -n 20 "$out/registration.log" >&2
        die "the registration failed"
    fi
}

# demo_headless DIR SECONDS SIZE PORT: each program on an Xvfb of its own, so that no window covers
# the other.
demo_headless() {
    local out=$1 seconds=$2 size=$3 port=$4
    mkdir -p "$out/session" 2> /dev/null || die "cannot write into $out"
    [ "$register" = no ] || register_headless "$out" "$size"
    rm -f "$out"/{instructor,trainee}.{png,json} "$out/summary.json" "$out/session/codes"
    local measure=(--measure "$out" --size "$size")
    local at_most=(timeout --kill-after=10 "$((seconds + 120))")
    # The console outlives the trainee, whose last picture then shows a session that runs.
    with_display "${at_most[@]}" "$build/apps/instructor/carina-instructor" --port "$port" \
        --data "$out/session" --codes "$out/session/codes" --new "${measure[@]}" \
        --seconds "$((seconds + 8))" "${play[@]}" "${patient[@]}" > "$out/instructor.log" 2>&1 &
    children+=($!)
    with_display "${at_most[@]}" "$build/apps/trainee/carina-trainee" --port "$port" --as Trainee \
        --data "$out/session" --code-file "$out/session/codes" --tracker "$tracker" \
        "${measure[@]}" --seconds "$seconds" "${patient[@]}" "${view[@]}" > "$out/trainee.log" 2>&1 &
    children+=($!)
    if ! wait_for_children; then
        tail -n 20 "$out/instructor.log" "$out/trainee.log" >&2
        die "the headless demo failed"
    fi
    with_display "$build/apps/lab/carina-lab" summary "$out" > "$out/summary.part"
    mv "$out/summary.part" "$out/summary.json"
    cat "$out/summary.json"
}

# choose_hands: what the hands do where --tracker does not say it. A headless demo measures breathing
# as a script sets it at the console: unless an intubation is asked for, nobody treats the patient
# there, and the hands begin at once. Sets of surfaces seldom have all that an intubation passes.
choose_hands() {
    [ -n "$intubation$tracker$out$anatomy" ] || intubation=good
    if [ -n "$intubation" ]; then
        tracker=simulated:intubation=$intubation,after=60
        play=(--play "$intubation")
    elif [ -z "$tracker" ]; then
        tracker=simulated
        [ -n "$anatomy" ] || tracker=simulated:intubation=good
    fi
}

# motions: their names with | between; the programs, which know them too, may not be built yet.
motions() {
    grep -oP 'NamedMotion\{"\K[a-z_]+' "$root/evaluation/intubation/motion_parameters.h" |
        paste -sd '|'
}

demo() {
    local out='' seconds='' size=1280x800 anatomy='' site='' register=no patient=() view=()
    local tracker='' intubation='' play=()
    local known=' --register --tracker --site --output --headless --anatomy --patient --seconds --size --intubation '
    while [ $# -gt 0 ]; do
        [[ $known == *" $1 "* ]] || refuse "demo does not know $1, or was given it twice"
        known=${known/" $1 "/ }
        if [ "$1" = --register ]; then
            register=yes
            shift
            continue
        fi
        [ $# -ge 2 ] || refuse "$1 needs a value"
        case $1 in
            --site) site=$(realpath -e "$2" 2> /dev/null) || refuse "there is no file $2" ;;
            --tracker) tracker=$2 ;;
            --intubation) intubation=$2 ;;
            --output) view+=(--output "$2") ;;
            --headless) out=$(realpath -m "$2")
                # A folder is made, and its way there is not: most likely that is a slip.
                [ -d "$(dirname "$out")" ] || refuse "--headless: there is no folder $(dirname "$out")" ;;
            --anatomy) anatomy=$(realpath -e "$2" 2> /dev/null) || refuse "there is no folder $2" ;;
            --patient) patient=(--patient "$2") ;;
            --seconds) seconds=$2 ;;
            --size) size=$2 ;;
        esac
        shift 2
    done
    local scripts
    scripts=$(motions)
    [ -z "$intubation" ] || [[ $intubation =~ ^($scripts)$ ]] ||
        refuse "--intubation is one of ${scripts//|/, }"
    [ -z "$intubation" ] || [ -z "$tracker" ] || refuse "--intubation plays on a tracker of its own"
    choose_hands
    # All of it takes about two minutes.
    [ -n "$seconds" ] || seconds=$([ -n "$intubation" ] && echo 120 || echo 24)
    [[ $seconds =~ ^[1-9][0-9]*$ ]] || refuse "--seconds takes a whole number above 0, not $seconds"
    [[ $size =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || refuse "--size takes WIDTHxHEIGHT, not $size"
    [ ${#patient[@]} = 0 ] || [[ ${patient[1],,} =~ ^((adult|child)(,.+)?|.+,.+,.+)$ ]] ||
        refuse "--patient is adult or child, also as in 'child, girl' and 'adult, airway 250 mm'," \
            "or age, height and sex, as in '45 years, 182 cm, man'"
    [ $register = no ] || [ -z "$site" ] || refuse "--register makes a site, and --site takes one"
    case $tracker in
        simulated) ;;
        simulated:*) # as readSimulatedOptions takes it, whose programs are not built yet
            local tool='(head|jaw|tube|stylus|manikin|chest|hand|laryngoscope)' number='[0-9]+([.][0-9]+)?'
            local option="(rate=$number|hidden=$tool|partly=$tool|dropouts=$number|with=laryngoscope"
            option+="|intubation=($scripts)|seed=[0-9]+|after=$number)"
            [[ ${tracker#simulated:} =~ ^$option(,$option)*$ ]] ||
                refuse "--tracker simulated takes rate=HZ (1 to 1000), hidden=TOOL, partly=TOOL," \
                    "dropouts=PERCENT (0 to 90), with=laryngoscope, intubation=SCRIPT, seed=N and" \
                    "after=SECONDS (0 to 600), with commas between, not" \
                    "${tracker#simulated:};" \
                    "TOOL is head, jaw, tube, stylus, manikin, chest, hand or laryngoscope" ;;
        site) [ -n "$site" ] || refuse "--tracker site needs --site, which names the devices" ;;
        recorded:* | looped:*) tracker=${tracker%%:*}:$(realpath -e "${tracker#*:}" 2> /dev/null) ||
            refuse "there is no recording ${tracker#*:}" ;;
        *) tracker=$(realpath -e "$tracker" 2> /dev/null) || refuse "there is no file of this --tracker" ;;
    esac
    [[ $tracker == simulated* ]] || [ -n "$site" ] || { [ $register = yes ] && [ -z "$out" ]; } ||
        refuse "--tracker needs --site, which says where the patient lies, or on a display --register"
    [ ${#view[@]} = 0 ] || [[ ${view[1]} =~ ^(screen|mono|side-by-side)$ ]] ||
        refuse "--output is screen, mono or side-by-side"

    [ -n "$out" ] || [ -n "${DISPLAY:-}" ] ||
        die "there is no display here; './carina demo --headless DIR' works without"
    install_packages
    local programs=(carina-surface-reader carina-instructor carina-trainee)
    [ $register = no ] || programs+=(carina-registration)
    [ -z "$out$anatomy" ] || programs+=(carina-lab) # imports the set, and writes the summary
    build_targets release "${programs[@]}"
    if [ -n "$anatomy" ]; then
        say "importing $anatomy"
        lab anatomy import "$anatomy" > /dev/null
        patient+=(--anatomy "$anatomy")
    fi
    if [ $register = yes ]; then begin_site "${out:-$(demo_folder)}"; fi
    [ -z "$site" ] || view+=(--site "$site")
    trap 'end_children; exit 130' INT TERM
    if [ -n "$out" ]; then
        demo_headless "$out" "$seconds" "$size" "$(free_port)"
    else
        demo_windows "$(free_port)"
    fi
}

