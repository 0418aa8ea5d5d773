#!/usr/bin/env bash
# run_site.sh SOURCE BUILD: makes the site of the documentation, whose generator fails at links without
# a target, and looks for a page and a node in its index of the search.
set -euo pipefail
site=$(mktemp -d)
trap 'rm -rf "$site"' EXIT
"$1/docs/site/make.py" "$2/bin/wrinkle" "$site/html"
for text in '"docs/tutorial"' uv_transform; do
    grep -qF "$text" "$site/html/searchindex.js" || { echo "site: the search has no $text" >&2; exit 1; }
done
[ -s "$site/html/index.html" ] || { echo "site: no index.html" >&2; exit 1; }
