// Tests of the scripts of graphs/bake for GNU parallel and Slurm: the result equals a bake on one
// machine, also after a job is killed.
#include <map>

#include "cli/killed_shard.h"
#include "farm/slurm.h"

namespace wrinkle::test {
namespace {

class FarmTest : public CliTest {
protected:
    using Names = std::vector<std::string>;
    const Names job = {WRINKLE_SOURCE_DIR "/graphs/noise_rock.json",
                       "--mesh",
                       "teapot",
                       "--size",
                       "1024",
                       "--map",
                       "normal,roughness"};

    Ran with(const std::string& other, Names args, const Names& environment) {
        program = other;
        args.insert(args.end(), job.begin(), job.end());
        const Ran ran = run(args, "", environment);
        program = WRINKLE_BINARY_DIR "/bin/wrinkle";
        return ran;
    }
    void expect_whole(const std::string& out) {
        const Ran ran = with(program, {"bake", "-o", "whole"}, {});
        ASSERT_EQ(ran.code, 0) << ran.err;
        for (const char* name : {"/normal.png", "/roughness.png"})
            EXPECT_TRUE(get("whole" + std::string(name)) == get(out + name)) << name;
    }
};

TEST_F(FarmTest, ParallelSaysWhatWasKilledAndBakesItAgainAlone) {
    const std::string script = WRINKLE_SOURCE_DIR "/graphs/bake/parallel.sh", out = "the maps";
    const std::string path = path_with_killer(folder, "3/5");
    const Ran killed = with(script, {"5", out}, {path});
    EXPECT_EQ(killed.code, 1);
    EXPECT_TRUE(says(killed.err, "the maps.parts/3: error: shard 3 of 5 is not finished"));
    EXPECT_FALSE(exists(out));
    EXPECT_EQ(times(take_calls(folder), "--shard"), 5U);

    put("killer/rm", "#!/bin/sh\n");  // `rm` does nothing: the parts are checked below
    fs::permissions(folder / "killer/rm", fs::perms::owner_all);
    const auto written = [&](const std::string& shard) {
        return fs::last_write_time(folder / (out + ".parts") / shard / "0-0.rows");
    };
    std::map<std::string, fs::file_time_type> before;
    for (const char* shard : {"1", "2", "3", "4", "5"})
        before[shard] = written(shard);
    const Ran again = with(script, {"5", out}, {path});
    EXPECT_EQ(again.code, 0) << again.err;
    for (const auto& [shard, when] : before)
        EXPECT_EQ(written(shard) == when, shard != "3") << shard;
    expect_whole(out);

    fs::remove(folder / "killer/rm");
    EXPECT_EQ(with(script, {"5", out}, {path}).code, 0);
    EXPECT_FALSE(exists(out + ".parts"));
}

class SlurmTest : public FarmTest {
protected:
    Slurm slurm{temporary.path() / "slurm"};
    const Names environment = {slurm.environment(), path_with_killer(folder, "3/5")};

    Ran batch(Names args) {
        args.insert(args.end(), {WRINKLE_SOURCE_DIR "/graphs/bake/slurm.sh", "5", "maps"});
        return with(SBATCH, args, environment);
    }
    Ran merge(const std::string& after) {
        program = SBATCH;
        const Ran ran = run({"--wait", "--output=merge.log", "--dependency=afterany:" + after,
                             "--wrap", "wrinkle bake --merge maps.parts/* -o maps"},
                            "", environment);
        program = WRINKLE_BINARY_DIR "/bin/wrinkle";
        return ran;
    }
    static std::string first_line(const std::string& text) {
        return text.substr(0, text.find('\n'));
    }
};

TEST_F(SlurmTest, AnArraySaysWhatWasKilledAndBakesItAgainAlone) {
    const Ran array = batch({"--parsable", "--array=1-5"});
    ASSERT_EQ(array.code, 0) << array.err << slurm.log();
    EXPECT_EQ(merge(first_line(array.out)).code, 1);
    EXPECT_TRUE(says(get("merge.log"), "maps.parts/3: error: shard 3 of 5 is not finished"));
    EXPECT_FALSE(exists("maps"));
    EXPECT_EQ(times(take_calls(folder), "--shard"), 5U);

    const Ran again = batch({"--parsable", "--array=3"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(merge(first_line(again.out)).code, 0) << get("merge.log") << slurm.log();
    const std::string calls = take_calls(folder);
    EXPECT_EQ(times(calls, "--shard"), 1U) << calls;
    EXPECT_EQ(times(calls, "--shard 3/5"), 1U) << calls;
    expect_whole("maps");
}

}  // namespace
}  // namespace wrinkle::test
