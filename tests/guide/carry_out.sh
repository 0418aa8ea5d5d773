# carry_out GUIDE BUILD: does what a page says, in an empty folder, with nothing of Wrinkle but what
# BUILD installs. To be sourced; a page's own test goes on in the folder $here/work.
#
# Every fenced block of the page is one of three: "```LANGUAGE FILE" is a file to write, "```sh" are
# commands, "```text" are lines that the commands before it must print.
here=$(mktemp -d)
screen="" running=""
finish() {
    [ -z "$running" ] || { echo "$guide: $running fails:"; cat "$block" "$printed"; } >&2
    [ -z "$screen" ] || kill "$screen" 2>/dev/null || true
    rm -rf "$here"
}
trap finish EXIT

fail() { echo "$guide: $*" >&2; exit 1; }

carry_out() {
    guide=$(realpath "$1") build=$(realpath "$2")
    mkdir "$here/work" "$here/blocks" "$here/home"
    cmake --install "$build" --prefix "$here/prefix" >"$here/install.log" 2>&1 || fail "$(cat "$here/install.log")"

    # The blocks as files, and their order as "NUMBER LINE LANGUAGE FILE".
    awk -v blocks="$here/blocks" '
        /^```/ && !inside { inside = ++count; print count, NR, substr($0, 4); printf "" > (blocks "/" count); next }
        /^```$/ { close(blocks "/" inside); inside = 0; next }
        inside { print > (blocks "/" inside) }
        END { if (inside) exit 1 }' "$guide" >"$here/order" || fail "a block has no end"

    local variable number line language file wanted
    for variable in $(compgen -e | grep -E '^(XDG_|WRINKLE_|CPATH$|CMAKE_PREFIX_PATH$|MAKEFLAGS$)' || true); do
        unset "$variable"
    done
    export HOME=$here/home PREFIX=$here/prefix
    command -v make >/dev/null || export CMAKE_GENERATOR=Ninja
    cd "$here/work"

    printed="" first=""
    while read -r number line language file; do
        block=$here/blocks/$number
        case $language/$file in
            sh/)
                printed=$here/printed.$number running="what begins in line $line"
                . "$block" >"$printed" 2>&1  # in this shell: the page sets variables
                running="" ;;
            text/)
                while IFS= read -r wanted; do
                    grep -qF -- "$wanted" "$printed" ||
                        fail "line $line: '$wanted' is not among what was printed:" "$(cat "$printed")"
                done <"$block" ;;
            */?*)
                cp "$block" "$file"
                [[ $file != *.cpp ]] || first=${first:-$file} ;;
            *) fail "line $line: a block of '$language' that is neither a file, nor sh, nor text" ;;
        esac
    done <"$here/order"
    cd "$here/work"
}
