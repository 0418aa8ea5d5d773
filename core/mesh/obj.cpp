#include "base/diagnostics.h"
#include "mesh/readers.h"
#include "mesh/weld.h"

#include <array>
#include <charconv>
#include <cmath>
#include <unordered_map>

namespace wrinkle {
namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr size_t max_problems = 20;  // a corrupt file has one in every line

// A face corner: indices of position, uv and normal.
using Corner = std::array<uint32_t, 3>;

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& file, const MeshLimits& limits,
              Diagnostics& diagnostics)
        : text_(text), file_(file), limits_(limits), diagnostics_(diagnostics) {}

    std::optional<Mesh> read() {
        while (!text_.empty() && problems_ < max_problems)
            read_line(next_line());
        if (problems_ > 0) return {};
        add_attributes();
        return std::move(mesh_);
    }

private:
    // Returns the next line; a backslash at the end of a line continues it.
    std::string_view next_line() {
        line_ += skipped_ + 1;
        skipped_ = 0;
        size_t end = text_.find('\n');
        while (end != text_.npos && is_continued(end)) {
            ++skipped_;
            end = text_.find('\n', end + 1);
        }
        const std::string_view line = text_.substr(0, end);
        text_.remove_prefix(std::min(line.size() + 1, text_.size()));
        begin_ = line.data();
        return line;
    }

    bool is_continued(size_t end) const {
        const bool returns = end > 0 && text_[end - 1] == '\r';
        const size_t last = end - (returns ? 1 : 0);
        return last > 0 && text_[last - 1] == '\\';
    }

    static std::string_view next_word(std::string_view& line) {
        constexpr std::string_view space = " \t\r\n\\\f\v";
        line.remove_prefix(std::min(line.find_first_not_of(space), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(space));
        line.remove_prefix(word.size());
        return word;
    }

    void read_line(std::string_view line) {
        const std::string_view word = next_word(line);
        if (word == "v")
            read_position(line);
        else if (word == "vt")
            read_uv(line);
        else if (word == "vn")
            read_normal(line);
        else if (word == "f")
            read_face(line);
    }

    // Reads up to N numbers and returns their count. Words after '#' are a comment.
    template <size_t N>
    size_t read_numbers(std::string_view line, std::array<float, N>& values, size_t min_count,
                        const char* statement) {
        size_t count = 0;
        for (std::string_view word = next_word(line); !word.empty() && word[0] != '#' && count < N;
             word = next_word(line)) {
            const std::string_view digits = word[0] == '+' ? word.substr(1) : word;
            const char* end = digits.data() + digits.size();
            double value = 0;
            const auto [stop, problem] = std::from_chars(digits.data(), end, value);
            const bool tiny =
                problem == std::errc::result_out_of_range &&
                (digits.find("e-") != digits.npos || digits.find("E-") != digits.npos);
            if ((problem != std::errc{} && !tiny) || stop != end ||
                !std::isfinite(static_cast<float>(value))) {
                error(word, "'" + shown(word) + "' is not a finite number", statement);
                return 0;
            }
            values[count++] = static_cast<float>(value);
        }
        if (count < min_count)
            error(line,
                  std::to_string(count) + " numbers where at least " + std::to_string(min_count) +
                      " belong",
                  statement);
        return count;
    }

    void read_position(std::string_view line) {
        std::array<float, 7> v{};
        const size_t count = read_numbers(line, v, 3, "v X Y Z, or v X Y Z R G B");
        positions_.emplace_back(v[0], v[1], v[2]);
        const size_t color = count == 6 ? 3 : 4;
        const bool has_color = count >= 6;
        any_color_ = any_color_ || has_color;
        colors_.push_back(has_color ? glm::vec4(v[color], v[color + 1], v[color + 2], 1)
                                    : glm::vec4(1));
    }

    void read_uv(std::string_view line) {
        std::array<float, 3> v{};
        read_numbers(line, v, 1, "vt U V");
        uvs_.emplace_back(v[0], v[1]);
    }

    void read_normal(std::string_view line) {
        std::array<float, 3> v{};
        read_numbers(line, v, 3, "vn X Y Z");
        normals_.emplace_back(v[0], v[1], v[2]);
    }

    // 1-based index; negative indices count back from the last element, -1.
    bool read_index(std::string_view word, size_t count, const char* what, uint32_t& index) {
        int64_t value = 0;
        const char* end = word.data() + word.size();
        const auto [stop, problem] = std::from_chars(word.data(), end, value);
        if (problem != std::errc{} || stop != end || value == 0) {
            error(word, "'" + shown(word) + "' is not an index of a " + what,
                  "a whole number from 1, or from -1 backwards");
            return false;
        }
        const auto size = static_cast<int64_t>(count);
        if (value > size || value < -size) {
            error(word, "there is no " + std::string(what) + " " + shown(word) + " here",
                  "the file has " + std::to_string(count) + " up to this line");
            return false;
        }
        index = static_cast<uint32_t>(value > 0 ? value - 1 : size + value);
        return true;
    }

    bool read_corner(std::string_view word, Corner& corner) {
        corner = {none, none, none};
        const size_t counts[] = {positions_.size(), uvs_.size(), normals_.size()};
        const char* names[] = {"vertex", "texture vertex", "vertex normal"};
        for (size_t k = 0; k < 3; ++k) {
            const size_t slash = word.find('/');
            const std::string_view index = word.substr(0, slash);
            if ((k == 0 || !index.empty()) && !read_index(index, counts[k], names[k], corner[k]))
                return false;
            if (slash == word.npos) return true;
            word.remove_prefix(slash + 1);
        }
        error(word, "more than three indices in a corner", "V, V/VT, V//VN or V/VT/VN");
        return false;
    }

    void read_face(std::string_view line) {
        const std::string_view whole = line;
        std::vector<uint32_t> corners;
        std::vector<glm::vec3> positions;
        for (std::string_view word = next_word(line); !word.empty() && word[0] != '#';
             word = next_word(line)) {
            Corner corner;
            if (!read_corner(word, corner)) return;
            positions.push_back(positions_[corner[0]]);
            corners.push_back(vertex_of(corner));
        }
        if (corners.size() < 3)
            return error(whole, "a face of " + std::to_string(corners.size()) + " corners",
                         "at least 3");
        if (mesh_.indices.size() + 3 * (corners.size() - 2) > limits_.max_corners) {
            error(whole, "more than " + std::to_string(limits_.max_corners / 3) + " triangles",
                  "split the file or simplify the mesh");
            problems_ = max_problems;
            return;
        }
        append_triangles(positions, corners, mesh_.indices);
    }

    uint32_t vertex_of(const Corner& corner) {
        const auto [at, is_new] =
            vertices_.try_emplace(corner, static_cast<uint32_t>(corners_.size()));
        if (is_new) corners_.push_back(corner);
        return at->second;
    }

    void add_attributes() {
        bool any_uv = false, any_normal = false;
        for (const Corner& corner : corners_) {
            any_uv = any_uv || corner[1] != none;
            any_normal = any_normal || corner[2] != none;
        }
        for (const auto& [position, uv, normal] : corners_) {
            mesh_.positions.push_back(positions_[position]);
            if (any_uv) mesh_.uvs[0].push_back(uv == none ? glm::vec2(0) : uvs_[uv]);
            if (any_normal)
                mesh_.normals.push_back(normal == none ? glm::vec3(0) : normals_[normal]);
            if (any_color_) mesh_.colors.push_back(colors_[position]);
        }
    }

    static std::string shown(std::string_view word) {
        std::string text;
        for (const char c : word.substr(0, 40))
            text += c > ' ' && c < 127 ? c : '?';
        return text + (word.size() > 40 ? "..." : "");
    }

    void error(std::string_view at, std::string message, std::string expected) {
        Diagnostic problem = file_problem(Severity::error, RuleId::mesh_unreadable, file_,
                                          std::move(message), std::move(expected));
        problem.where.line = line_;
        problem.where.column = static_cast<uint32_t>(at.data() - begin_) + 1;
        diagnostics_.add(std::move(problem));
        ++problems_;
    }

    std::string_view text_;
    const std::string& file_;
    const MeshLimits& limits_;
    Diagnostics& diagnostics_;
    const char* begin_ = nullptr;  // start of the line
    uint32_t line_ = 0, skipped_ = 0;
    size_t problems_ = 0;
    std::vector<glm::vec3> positions_, normals_;
    std::vector<glm::vec2> uvs_;
    std::vector<glm::vec4> colors_;
    bool any_color_ = false;
    std::vector<Corner> corners_;  // one per vertex of the mesh
    std::unordered_map<Corner, uint32_t, ArrayHash<Corner>> vertices_;
    Mesh mesh_;
};

}  // namespace

std::optional<Mesh> read_obj(std::string_view text, const std::string& file,
                             const MeshLimits& limits, Diagnostics& diagnostics) {
    return ObjReader(text, file, limits, diagnostics).read();
}

}  // namespace wrinkle
