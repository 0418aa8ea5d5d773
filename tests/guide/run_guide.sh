#!/usr/bin/env bash
# run_guide.sh GUIDE BUILD: carries the plugin author's guide out (carry_out.sh). Whatever is written as a
# source must come to be built, the first node has at most 12 lines, and the editor finds it.
set -euo pipefail
. "$(dirname "$0")/carry_out.sh"
carry_out "$@"

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
