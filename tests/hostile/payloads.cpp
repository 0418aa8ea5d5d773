#include "hostile/payloads.h"

namespace wrinkle::hostile {

namespace {

const std::vector<std::string> all_payloads = {
    "",
    // comments and lines of a generated source
    "\n#error HOSTILE",
    "\r\n#error HOSTILE\r\n",
    "*/ HOSTILE(); /*",
    "// HOSTILE",
    "\\",
    "x\\\n#error HOSTILE",
    "x ?\?/\n#error HOSTILE",
    "void main() { HOSTILE(); }",
    "gl_FragColor",
    "main",
    "float",
    "__LINE__",
    "wrinkle__hostile",
    // terminals and editors
    "\x1B[31mHOSTILE\x1B[0m",
    "\x1B]0;HOSTILE\x07",
    "HOSTILE\b\b\b\b",
    "\x7FHOSTILE",
    "\xC2\x9B"
    "31mHOSTILE",
    "\xD8\x9CHOSTILE",
    "\xE2\x80\xAEHOSTILE",
    "\xE2\x81\xA6HOSTILE",
    "\xE2\x80\xA8#error HOSTILE",
    "\xE2\x80\xA9#error HOSTILE",
    "\xEF\xBB\xBFHOSTILE",
    "\xE2\x80\x8BHOSTILE",
    std::string("HOSTILE\0HOSTILE", 15),
    // not UTF-8
    "\xFF\xFEHOSTILE",
    "\xC0\xAF",
    "\xED\xA0\x80",
    // forged messages
    "other.json:1:1: error: HOSTILE",
    "\nother.json:1:1: error: HOSTILE",
    // paths
    "../../../../../../etc/passwd",
    "/etc/passwd",
    "../outside/secret.txt",
    "../outside/secret.json",
    "link_out/secret.txt",
    "secret_link.json",
    "/dev/zero",
    "/dev/stdin",
    "fifo",
    ".",
    "..",
    // command lines, shells, Make, Ninja
    "-",
    "--plugin-path=HOSTILE",
    "@options",
    "$(touch HOSTILE)",
    "`touch HOSTILE`",
    "'; touch HOSTILE; '",
    "a: b c#d$e%f\tg",
    "a\n\ttouch HOSTILE",
    // formats and markup
    "%s%n%p%1000000d",
    "${HOSTILE}",
    "<script>HOSTILE</script>&quot;]]>",
    "\"},{\"HOSTILE\":\"",
    // names of the graph format
    "a.b.c",
    "surface.uv0",
    "graph:graph.json",
    "base",
    "\xF0\x9F\xA6\x86",
    std::string(100'000, 'A'),
};

}  // namespace

const std::vector<std::string>& payloads() {
    return all_payloads;
}

}  // namespace wrinkle::hostile
