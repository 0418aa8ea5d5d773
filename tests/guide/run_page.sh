#!/usr/bin/env bash
# run_page.sh PAGE BUILD: carries out a page (carry_out.sh).
set -euo pipefail
. "$(dirname "$0")/carry_out.sh"
carry_out "$@"
echo "$(wc -l <"$here/order") blocks"
