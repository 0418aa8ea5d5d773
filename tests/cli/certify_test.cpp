// Tests of wrinkle plugins --test FILE: output and exit codes.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

const std::string good = WRINKLE_BINARY_DIR "/lib/wrinkle/plugins/ripples.so";
const std::string faulty = WRINKLE_BINARY_DIR "/lib/wrinkle/test/test_plugin_faulty.so";
const std::string ending = WRINKLE_BINARY_DIR "/lib/wrinkle/test/test_plugin_ending.so";

using CertifyTest = CliTest;

TEST_F(CertifyTest, OfAFinePluginEndsWithZero) {
    const Ran ran = run({"plugins", "--test", good});
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(ran.out.starts_with(good + "\n    ripples 1.0\nripples  ok: ")) << ran.out;
    EXPECT_TRUE(says(ran.out, "\nGPU: "));
    EXPECT_TRUE(ran.out.ends_with("\n1 ok, 0 failed\n"));
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(CertifyTest, WithoutAGpuSaysSoAndEndsWithThreeUnlessAsked) {
    const Ran ran = run({"plugins", "--test", good}, "", without_gl());
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_TRUE(says(ran.out, "ripples  ok: 1200 values in float, double, 800 derivatives\n"));
    EXPECT_TRUE(says(ran.out, "GPU: NOT RUN, CPU and GPU were not compared ("));
    const Ran asked = run({"plugins", "--test", good, "--no-gpu"});
    EXPECT_EQ(asked.code, 0) << asked.err;
    EXPECT_TRUE(says(asked.out, "GPU: NOT RUN, CPU and GPU were not compared (--no-gpu)\n"));
}

TEST_F(CertifyTest, NamesEveryFault) {
    const Ran ran = run({"plugins", "--test", faulty, "--no-gpu", "--diagnostics", "json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "undocumented  failed\n    descriptor: "));
    EXPECT_TRUE(says(ran.out, "divides  failed\n    finite: port 'height': "));
    EXPECT_TRUE(says(ran.out, "\n1 ok, 9 failed\n")) << ran.out;  // one fault shows only on a GPU
    const json::Value list = parsed(ran.err).find("diagnostics");
    ASSERT_GE(list.size(), 9U);
    EXPECT_EQ(list.at(0).find("file").as_string(), faulty);
    EXPECT_EQ(list.at(0).find("node").as_string(), "terraces");
    EXPECT_TRUE(says(std::string(list.at(0).find("message").as_string()), "detach: port 'height'"));
}

TEST_F(CertifyTest, AllowsWhatIsMeant) {
    const Ran ran = run(
        {"plugins", "--test", faulty, "--no-gpu", "--allow", "detach", "--allow", "descriptor"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "terraces  ok: "));
    EXPECT_TRUE(says(ran.out, "undocumented  ok: "));
    EXPECT_TRUE(says(ran.out, "\n4 ok, 6 failed\n"));
    EXPECT_EQ(run({"plugins", "--test", good, "--allow", "everything"}).code, 2);
}

TEST_F(CertifyTest, ANodeThatEndsItsProcessHasAFinding) {
    const Ran ran = run({"plugins", "--test", ending, "--no-gpu"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "steady  ok: "));
    EXPECT_TRUE(says(ran.out, "the plugin " + ending +
                                  " cannot be used: it crashed in build(): SIGABRT (Aborted)"));
    EXPECT_TRUE(says(ran.out, "\n1 ok, 1 failed\n"));
}

TEST_F(CertifyTest, RefusesWhatIsNoPlugin) {
    put("p.so", "not a library");
    const Ran ran = run({"plugins", "--test", "p.so"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "p.so: error: "));
    EXPECT_EQ(run({"plugins", "--test", "none.so"}).code, 1);
    EXPECT_EQ(run({"plugins", "--no-gpu"}).code, 2);
}

}  // namespace
}  // namespace wrinkle::test
