#include "emit/language.h"

#include <algorithm>

namespace wrinkle {

void append_filled(std::string& text, std::string_view pattern,
                   std::initializer_list<Field> fields) {
    for (;;) {
        const size_t mark = pattern.find('$');
        text += pattern.substr(0, mark);
        if (mark == pattern.npos) return;
        const char letter = pattern[mark + 1];
        const auto* const field = std::ranges::find(fields, letter, &Field::letter);
        if (field != fields.end()) text += field->text;
        pattern.remove_prefix(mark + 2);
    }
}

std::string filled(std::string_view pattern, std::initializer_list<Field> fields) {
    std::string text;
    append_filled(text, pattern, fields);
    return text;
}

void append_item(std::string& list, std::string_view item) {
    if (!list.empty() && !item.empty()) list += ", ";
    list += item;
}

void reserve_words(Language& language, std::string_view words) {
    for (size_t begin = 0; (begin = words.find_first_not_of(" \n", begin)) != words.npos;) {
        const size_t end = std::min(words.find_first_of(" \n", begin), words.size());
        language.reserved.add({{}, words.substr(begin, end - begin)});
        begin = end;
    }
}

}  // namespace wrinkle
