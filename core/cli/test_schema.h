// The keys of .test.json files, once: for the reader (cli/test_case.h) and for the JSON Schema that
// `wrinkle test --schema` prints. docs/test-cases.md has a line for each.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

// Values are JSON text; `schema` holds the members of the value's schema.
struct CaseKey {
    std::string name, doc, schema, fallback, example;  // fallback "": no default
};

const std::vector<CaseKey>& case_keys();    // of the file
const std::vector<CaseKey>& render_keys();  // of its "render"

std::vector<std::string> names_of(std::span<const CaseKey> keys);

std::string case_schema();

}  // namespace wrinkle::cli
