// Keys of .test.json files, shared by the reader (cli/test_case.h) and the JSON Schema that
// `wrinkle test --schema` prints. docs/test-cases.md documents each key.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

// Values are JSON text. `schema` holds the members of the JSON Schema of the value.
struct CaseKey {
    std::string name, doc, schema, fallback, example;  // fallback "": no default
};

const std::vector<CaseKey>& case_keys();    // top-level keys
const std::vector<CaseKey>& render_keys();  // keys of "render"

std::vector<std::string> names_of(std::span<const CaseKey> keys);

std::string case_schema();

}  // namespace wrinkle::cli
