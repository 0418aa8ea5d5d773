#!/usr/bin/env bash
# run_guide.sh GUIDE BUILD: does what the plugin author's guide says, in an empty folder, with nothing
# of Wrinkle but what BUILD installs.
#
# Every fenced block of the guide is one of three: "```LANGUAGE FILE" is a file to write, "```sh" are
# commands, "```text" are lines that the commands before it must print. Whatever is written as a source
# must come to be built, the first node has at most 12 lines, and the editor finds it.
set -euo pipefail
guide=$(realpath "$1") build=$(realpath "$2")
here=$(mktemp -d)
screen="" running=""
finish() {
    [ -z "$running" ] || { echo "$guide: $running fails:"; cat "$block" "$printed"; } >&2
    [ -z "$screen" ] || kill "$screen" 2>/dev/null || true
    rm -rf "$here"
}
trap finish EXIT
mkdir "$here/work" "$here/blocks" "$here/home"

fail() { echo "$guide: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$here/prefix" >"$here/install.log" 2>&1 || fail "$(cat "$here/install.log")"

# The blocks as files, and their order as "NUMBER LINE LANGUAGE FILE".
awk -v blocks="$here/blocks" '
    /^```/ && !inside { inside = ++count; print count, NR, substr($0, 4); printf "" > (blocks "/" count); next }
    /^```$/ { close(blocks "/" inside); inside = 0; next }
    inside { print > (blocks "/" inside) }
    END { if (inside) exit 1 }' "$guide" >"$here/order" || fail "a block has no end"

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
            . "$block" >"$printed" 2>&1  # in this shell: the guide sets variables
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

[ -n "$first" ] || fail "there is no node in it"
lines=$(wc -l <"$first")
[ "$lines" -le 12 ] || fail "the first node, $first, has $lines lines in place of 12"
for source in *.cpp *.c; do
    plugin=nodes/${source%.*}.so
    [ -e "$plugin" ] || fail "$source is not built"
    # gcc's unique symbols are shared by all libraries of a process, and keep them loaded for good.
    ! nm -D --defined-only "$plugin" | grep ' u ' || fail "$plugin has unique symbols"
done

id=${first%.*}
if command -v Xvfb >/dev/null; then
    coproc x_server { exec Xvfb -displayfd 1 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null; }
    screen=$x_server_PID
    read -r display <&"${x_server[0]}" || fail "no display"
    printf 'key Space\ntype %s\nassert target palette:%s\nkey Enter\nassert nodes 3\nassert node %s\n' \
        "$id" "$id" "$id" >script.txt
    # GLFW unloads the driver, and what that leaks has no name left to be exempt by.
    ASAN_OPTIONS=${ASAN_OPTIONS:-}:detect_leaks=0 \
        DISPLAY=:$display wrinkle-editor tiles.json --script script.txt || fail "the editor does not find $id"
fi
echo "$(wc -l <"$here/order") blocks"
