# Runs a program that nobody trusts, with limits:
#   sh sandbox.sh all|build|check|picture workbook|program FOLDER PROGRAM...
# in FOLDER/workbook or FOLDER/program. To compile it may write to FOLDER/target, to draw a picture to
# FOLDER/pictures, otherwise nowhere. With bubblewrap it sees the folder as /course, Rust and the system's programs, and no network.
# Its output is in FOLDER/output. The student's program prints its answers there, too.
kind=$1 place=$2 folder=$3
shift 3
# Seconds of processor time of a process, of which the whole may take three times as long; MiB of
# memory of a process, and of a file; processes and threads.
case $kind in
    all) seconds=1200 memory=8192 file=1024 processes=256 ;;
    build) seconds=60 memory=4096 file=256 processes=128 ;;
    check) seconds=10 memory=1024 file=64 processes=32 ;;
    # The sheet says how long a picture may take, here on two processors.
    picture) seconds=$((2 * PICTURE_SECONDS)) memory=2048 file=64 processes=32 ;;
esac
rust=$(rustc --print sysroot)
cargo=${CARGO_HOME:-$HOME/.cargo}
path=/usr/bin:/bin
if [ "$kind" = picture ]; then
    # Nothing stays of an earlier one. With bubblewrap the program runs as nobody.
    rm -rf "$folder/pictures" && mkdir -m 777 "$folder/pictures" || exit
fi
# A block has 512 bytes in POSIX.
limits="ulimit -c 0; ulimit -t $seconds; ulimit -v $((memory * 1024)); ulimit -f $((file * 2048))"
run='exec "$@"'
clean="env -i EXERCISE_MODE=grader RAYON_NUM_THREADS=2"
[ "$kind" = picture ] && late=$seconds || late=$((3 * seconds))
late="timeout -s KILL $late"

alone='bwrap --unshare-pid --unshare-net --unshare-ipc --unshare-uts --die-with-parent
    --new-session --proc /proc --dev /dev --cap-drop ALL --ro-bind /usr /usr
    --ro-bind-try /bin /bin --ro-bind-try /lib /lib --ro-bind-try /lib64 /lib64
    --ro-bind-try /etc/alternatives /etc/alternatives --ro-bind-try /etc/ld.so.cache /etc/ld.so.cache'
# Limits of processes do not hold root, which therefore becomes nobody.
nobody='setpriv --reuid=65534 --regid=65534 --clear-groups --no-new-privs'
if [ "$(id -u)" = 0 ]; then
    alone="$alone --cap-add CAP_SETUID --cap-add CAP_SETGID"
else
    alone="$alone --unshare-user"
    nobody=
fi

if ! $alone true 2>/dev/null; then
    if [ "$kind" = all ]; then
        echo "note: bubblewrap (bwrap) does not run here, so submissions have limits of time, memory" \
            "and file size only: they can read and delete your files, use the network, and start and" \
            "leave behind any number of processes; install it, or grade in a container that you" \
            "throw away" >&2
    fi
    exec >"$folder/output" 2>&1
    cd "$folder/$place" || exit
    # A limit of processes would count all those of the user.
    exec $clean PATH="$rust/bin:$path" CARGO_HOME="$cargo" CARGO_TARGET_DIR="$folder/target" \
        TMPDIR="$folder/target" $late sh -c "$limits; $run" sh "$@"
fi
exec >"$folder/output" 2>&1
# The letter of this limit differs by shell.
limits="$limits; ulimit -u $processes 2>/dev/null || ulimit -p $processes"
set -- sh -c "$limits; $run" sh "$@"
case $kind in
    check) set -- --remount-ro / --chdir "/course/$place" $nobody "$@" ;;
    picture) set -- --bind "$folder/pictures" /course/pictures --remount-ro / --chdir "/course/$place" $nobody "$@" ;;
    *) set -- --bind "$folder/target" /course/target --chdir "/course/$place" "$@" ;;
esac
exec $clean PATH="/rust/bin:$path" CARGO_HOME="$cargo" CARGO_TARGET_DIR=/course/target \
    TMPDIR=/course/target $late $alone --ro-bind "$rust" /rust \
    --ro-bind-try "$cargo/registry" "$cargo/registry" --ro-bind "$folder" /course "$@"
