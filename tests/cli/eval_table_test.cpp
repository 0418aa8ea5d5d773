// Tests of wrinkle eval with tables: CSV and NPY input and output, and many points of a mesh. NPY
// files are assembled here by the format's specification; values are compared with the JSON form.
#include <charconv>
#include <cstring>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

const std::string bump_graph = R"({"wrinkle": 1, "nodes": {
    "split": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
    "wave": {"type": "multiply", "in": {"a": {"from": "split.x"}, "b": {"from": "split.y"}}},
    "bump": {"type": "gradient_from_height", "in": {"height": {"from": "wave.result"}}},
    "end": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}}},
    "outputs": {"normal": {"from": "end.normal"}, "wave": {"from": "wave.result"}}})";

const std::string bump_columns =
    "normal.x,normal.y,normal.z,uv0.x,uv0.y,position.x,position.y,position.z,"
    "dx.position.x,dx.position.y,dx.position.z,dy.position.x,dy.position.y,dy.position.z,"
    "dx.uv0.x,dx.uv0.y,dy.uv0.x,dy.uv0.y";

template <class T>
std::string raw(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

// An NPY file of version 1.0, as NumPy writes it.
std::string npy(const std::string& descr, const std::string& shape, const std::string& data,
                const std::string& order = "False") {
    std::string header =
        "{'descr': " + descr + ", 'fortran_order': " + order + ", 'shape': " + shape + ", }";
    header.append(63 - (10 + header.size()) % 64, ' ');
    header += '\n';
    return "\x93NUMPY\x01" + std::string(1, '\0') + raw(static_cast<uint16_t>(header.size())) +
           header + data;
}

class EvalTableTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("g.json", bump_graph);
        put("ramp.json", ramp_graph("2"));
    }
    std::string refused(const Names& args) const {
        Names all = {"eval", "ramp.json"};
        all.insert(all.end(), args.begin(), args.end());
        const Ran ran = run(all);
        EXPECT_EQ(ran.code, 1) << testing::PrintToString(args);
        EXPECT_EQ(ran.out, "");
        return ran.err;
    }
};

// Points over a plane with slightly rotated normals, as rows of bump_columns.
std::vector<std::vector<double>> bump_rows() {
    std::vector<std::vector<double>> rows;
    for (int i = 0; i < 20000; ++i) {  // more than one block
        const double u = i * 0.37, v = i * 0.11;
        rows.push_back({0, 0.1, 1, u, v, u, v, 0, 0.01, 0, 0, 0, 0.01, -0.001, 0.01, 0, 0, 0.01});
    }
    return rows;
}

std::string text_of(double value) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string csv_of(const std::vector<std::vector<double>>& rows) {
    std::string text = bump_columns + "\n";
    for (const auto& row : rows) {
        for (size_t i = 0; i < row.size(); ++i)
            text += (i ? "," : "") + text_of(row[i]);
        text += '\n';
    }
    return text;
}

std::string json_of(const std::vector<std::vector<double>>& rows) {
    const auto list = [](const std::vector<double>& row, size_t first, size_t count) {
        std::string text = "[";
        for (size_t i = first; i < first + count; ++i)
            text += (i > first ? ", " : "") + text_of(row[i]);
        return text + "]";
    };
    std::string text = "[";
    for (const auto& r : rows)
        text += (text.size() > 1 ? ",\n" : "") + ("{\"normal\": " + list(r, 0, 3)) +
                ", \"uv0\": " + list(r, 3, 2) + ", \"position\": " + list(r, 5, 3) +
                ", \"dx\": {\"position\": " + list(r, 8, 3) + ", \"uv0\": " + list(r, 14, 2) +
                "}, \"dy\": {\"position\": " + list(r, 11, 3) + ", \"uv0\": " + list(r, 16, 2) +
                "}}";
    return text + "]";
}

TEST_F(EvalTableTest, ATableGivesTheNumbersOfJson) {
    const auto rows = bump_rows();
    put("p.csv", csv_of(rows));
    put("p.json", json_of(rows));
    std::string descr = "[", data;
    for (size_t first = 0; first < bump_columns.size();) {
        const size_t end = std::min(bump_columns.find(',', first), bump_columns.size());
        descr += "('" + bump_columns.substr(first, end - first) + "', '<f8'), ";
        first = end + 1;
    }
    for (const auto& row : rows)
        for (const double value : row)
            data += raw(value);
    put("p.npy", npy(descr + "]", "(" + std::to_string(rows.size()) + ",)", data));
    for (const std::string precision : {"float", "double"}) {
        const auto eval = [&](const std::string& at) {
            const Ran ran = run({"eval", "g.json", "--at", at, "--precision", precision});
            EXPECT_EQ(ran.code, 0) << ran.err;
            return ran.out;
        };
        const std::string wanted = eval("@p.json");
        EXPECT_GT(wanted.size(), 500'000U);
        EXPECT_EQ(eval("p.csv"), wanted);
        EXPECT_EQ(eval("@p.csv"), wanted);
        EXPECT_EQ(eval("p.npy"), wanted);
    }
}

TEST_F(EvalTableTest, ResultsAreTheSameInEveryForm) {
    put("p.csv", csv_of(bump_rows()));
    for (const bool doubles : {false, true}) {
        const auto eval = [&](const Names& more) {
            Names args = {"eval",  "g.json",      "--at",
                          "p.csv", "--precision", doubles ? "double" : "float"};
            args.insert(args.end(), more.begin(), more.end());
            const Ran ran = run(args);
            EXPECT_EQ(ran.code, 0) << ran.err;
            return ran.out;
        };
        const json::Value points = parsed(eval({})).find("points");
        EXPECT_EQ(eval({"-o", "r.npy"}), "");
        std::string csv = "normal.x,normal.y,normal.z,wave\n", records;
        for (const json::Member& point : points.children()) {
            std::vector<json::Value> numbers;
            for (const json::Member& lane : point.value.find("normal").children())
                numbers.push_back(lane.value);
            numbers.push_back(point.value.find("wave"));
            for (const json::Value& number : numbers) {
                csv += std::string(number.spelling()) + (&number == &numbers.back() ? "\n" : ",");
                records +=
                    doubles ? raw(number.as_number()) : raw(static_cast<float>(number.as_number()));
            }
        }
        EXPECT_EQ(eval({"--format", "csv"}), csv);
        const std::string file = get("r.npy");
        const size_t header = file.size() - records.size();
        EXPECT_EQ(header % 64, 0U);
        EXPECT_EQ(file.substr(header), records);
        const std::string type = doubles ? "<f8" : "<f4";
        EXPECT_TRUE(says(file.substr(0, header), "('normal.z', '" + type + "'), ('wave', '"));
        EXPECT_TRUE(says(file.substr(0, header), "'shape': (20000,), }"));
    }
}

TEST_F(EvalTableTest, AFileHasTheTextOfStandardOutput) {
    put("uvs.csv", "uv0.y,uv0.x\n1,0.25\n2,-3\n");
    ASSERT_EQ(run({"eval", "ramp.json", "--at", "uvs.csv", "-o", "r.json"}).code, 0);
    EXPECT_EQ(get("r.json"), "{\"points\": [\n  {\"value\": 0.5},\n  {\"value\": -6}\n]}\n");
    put("none.csv", "uv0.y,uv0.x\n");
    EXPECT_EQ(run({"eval", "ramp.json", "--at", "none.csv", "--format", "csv"}).out, "value\n");
}

TEST_F(EvalTableTest, PlacesOfAMeshAreThoseOfSingleCalls) {
    std::string csv = "uv0.x,uv0.y\n", records;
    std::vector<std::string> places;
    for (int i = 0; i < 12; ++i) {
        const float u = 0.03F + 0.08F * static_cast<float>(i),
                    v = 0.95F - 0.07F * static_cast<float>(i);
        places.push_back(text_of(u) + "," + text_of(v));
        csv += places.back() + "\n";
        records += raw(u) + raw(v);
    }
    put("p.csv", csv);
    put("p.npy", npy("[('uv0.x', '<f4'), ('uv0.y', '<f4')]", "(12,)", records));
    std::string wanted = "{\"points\": [";
    for (size_t i = 0; i < places.size(); ++i) {
        const Ran one = run({"eval", "g.json", "--mesh", "torus", "--uv", places[i]});
        ASSERT_EQ(one.code, 0) << one.err;
        const size_t first = one.out.find("\n  ");
        wanted += (i > 0 ? "," : "") + one.out.substr(first, one.out.find("\n]") - first);
    }
    for (const char* at : {"p.csv", "p.npy"})
        EXPECT_EQ(run({"eval", "g.json", "--mesh", "torus", "--at", at}).out, wanted + "\n]}\n");
    EXPECT_EQ(
        run({"eval", "ramp.json", "--mesh", "torus", "--at", R"([{"uv0": [0.25, 0.5]}])"}).out,
        "{\"points\": [\n  {\"value\": 0.5}\n]}\n");
    put("out.csv", "uv0.x,uv0.y\n0.5,0.5\n7,0.5\n");
    EXPECT_TRUE(says(refused({"--mesh", "torus", "--at", "out.csv"}),
                     "out.csv:3:1: error: point 1: no triangle of the mesh torus covers"));
    put("other.csv", "uv1.x,uv1.y\n0.5,0.5\n");
    EXPECT_TRUE(says(refused({"--mesh", "torus", "--at", "other.csv"}), "lacks 'uv0'"));
}

TEST_F(EvalTableTest, ASweepWritesAFileForEachRun) {
    put("p.csv", "uv0.x,uv0.y\n1,0\n");
    ASSERT_EQ(
        run({"eval", "ramp.json", "--at", "p.csv", "--set", "scaled.b=0:2:3", "-o", "r.csv"}).code,
        0);
    EXPECT_EQ(get("r.002.csv"), "value\n2\n");
    ASSERT_EQ(run({"eval", "ramp.json", "--at", "p.csv", "--set", "scaled.b=0:2:3", "--format",
                   "csv", "-o", ".csv"})
                  .code,
              0);
    EXPECT_EQ(get(".csv.002"), "value\n2\n");
    for (const Names& more : {Names{"--format", "csv", "--set", "scaled.b=0:2:3"},
                              Names{"-o", "r.txt"}, Names{"-o", "r"}}) {
        Names args = {"eval", "ramp.json", "--at", "p.csv"};
        args.insert(args.end(), more.begin(), more.end());
        EXPECT_EQ(run(args).code, 2) << testing::PrintToString(more);
    }
    EXPECT_FALSE(exists("r.txt"));
}

TEST_F(EvalTableTest, ReportsABadCsv) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "there is no column ''"},
        {"uv0.x,uv0.z\n", "p.csv:1:1: error: there is no column 'uv0.z' (did you mean 'uv0."},
        {"uv0\n", "there is no column 'uv0'"},
        {"uv0.x,uv0.x\n", "column 'uv0.x' is there twice"},
        {"uv0.x\n1\n", "column 'uv0.y' is missing"},
        {"normal.x,normal.y,normal.z\n0,0,1\n", "the table lacks 'uv0'"},
        {"uv0.x,uv0.y\n1,2\n3\n", "p.csv:3:1: error: point 1 has 1 numbers"},
        {"uv0.x,uv0.y\n1,2,3\n", "point 0 has 3 numbers (2, as the first line has names)"},
        {"uv0.x,uv0.y\n1,x\n", "'x' is not a number"},
        {"uv0.x,uv0.y\n1,\n", "'' is not a number"},
        {"uv0.x,uv0.y\n\n1,2\n", "p.csv:2:1:"},
        {"uv0.x,uv0.y\n1,nan\n", "'uv0.y' is not a finite number"},
        {"uv0.x,uv0.y\n1,2\n1e300,0\n", "p.csv:3:1: error: point 1: 'uv0' holds 1e+300"},
        {"uv0.x,uv0.y,normal.x,normal.y,normal.z\n1,2,0,0,0\n", "normal is zero"},
        {"dx.facing\n1\n", "there is no column 'dx.facing'"},
    };
    for (const auto& [text, words] : cases) {
        put("p.csv", text);
        EXPECT_TRUE(says(refused({"--at", "p.csv"}), words)) << text;
    }
    EXPECT_TRUE(says(refused({"--at", "gone.csv"}), "gone.csv"));
    // The reader skips the additions of spreadsheets: byte order mark, quotes, blanks, empty lines.
    put("p.csv", "\xEF\xBB\xBF\"uv0.x\", uv0.y,facing\r\n0.5 , 1,-1\r\n\r\n");
    EXPECT_EQ(run({"eval", "ramp.json", "--at", "p.csv", "--format", "csv"}).out, "value\n1\n");
}

TEST_F(EvalTableTest, ReportsABadNpy) {
    const std::string uv = "[('uv0.x', '<f4'), ('uv0.y', '<f4')]", two = raw(0.5F) + raw(1.F);
    const std::string whole = npy(uv, "(1,)", two);
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "is not a whole NPY file"},
        {whole.substr(0, 30), "is not a whole NPY file"},
        {"\x93NUMPY\x04" + whole.substr(7), "is not a whole NPY file"},
        {whole.substr(0, whole.size() - 1), "holds 7 bytes of points, not 1 records of 8"},
        {whole + "x", "holds 9 bytes of points"},
        {npy(uv, "(99999999999999999999,)", two), "has a header that cannot be read"},
        {npy(uv, "(2305843009213693953,)", two), "holds 8 bytes of points"},
        {npy(uv, "(1, 1)", two), "more than one dimension"},
        {npy(uv, "()", two), "has a header that cannot be read"},
        {npy("'<f4'", "(2,)", two), "holds numbers without names"},
        {npy("[('uv0.x', '>f4'), ('uv0.y', '<f4')]", "(1,)", two), "of type >f4"},
        {npy("[('uv0', '<f4', (2,))]", "(1,)", two), "a field 'uv0' of several numbers"},
        {npy("[('uv0.x', '<f4'), ('uv0.q', '<f4')]", "(1,)", two), "no column 'uv0.q'"},
        {npy("[('uv0.x', '<f8')]", "(1,)", two), "column 'uv0.y' is missing"},
        {npy("[]", "(1,)", two), "has a header that cannot be read"},
        {npy("[('', '|V8')]", "(1,)", two), "has a header that cannot be read"},
        {npy(uv, "(1,)", two, "True"), "has Fortran order"},
        {npy(uv + ", 'more': 1", "(1,)", two), "has a header that cannot be read"},
        {npy("[('uv0.x', '<f4') 'more']", "(1,)", two), "has a header that cannot be read"},
        {npy(uv, "(1,)", raw(0.5F) + raw(std::stof("inf"))), "is not a finite number"},
    };
    for (const auto& [bytes, words] : cases) {
        put("p.npy", bytes);
        EXPECT_TRUE(says(refused({"--at", "p.npy"}), words)) << bytes;
    }
    // An aligned record has padding.
    put("p.npy", npy("[('uv0.x', '<f4'), ('', '|V4'), ('uv0.y', '<f8')]", "(1,)",
                     raw(0.5F) + "gaps" + raw(1.0)));
    EXPECT_EQ(run({"eval", "ramp.json", "--at", "p.npy", "--format", "csv"}).out, "value\n1\n");
}

}  // namespace
}  // namespace wrinkle::test
