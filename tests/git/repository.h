// A Git repository in the folder of a command-line test, without the configuration of the user.
#pragma once

#include "cli/support.h"

namespace wrinkle::test {

class GitTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        git({"init", "-q", "-b", "main"});
        EXPECT_EQ(wrinkle({"git-setup"}).code, 0);
        put("README", "x\n");
        commit("first");
    }

    Ran git(const std::vector<std::string>& words) {
        const std::string self = std::exchange(program, GIT);
        const Ran ran = run(words, "", environment());
        program = self;
        return ran;
    }
    Ran wrinkle(const std::vector<std::string>& words) { return run(words, "", environment()); }

    void commit(const std::string& message) {
        EXPECT_EQ(git({"add", "-A"}).code, 0);
        const Ran ran = git({"commit", "-q", "-m", message});
        EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
    }
    void checkout(const std::vector<std::string>& words) {
        std::vector<std::string> all = {"checkout", "-q"};
        all.insert(all.end(), words.begin(), words.end());
        const Ran ran = git(all);
        EXPECT_EQ(ran.code, 0) << ran.err;
    }

    static std::vector<std::string> environment() {
        return {"GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_NOSYSTEM=1", "GIT_AUTHOR_NAME=a",
                "GIT_AUTHOR_EMAIL=a@b",        "GIT_COMMITTER_NAME=a",  "GIT_COMMITTER_EMAIL=a@b",
                "GIT_MERGE_AUTOEDIT=no",       "GIT_PAGER=cat"};
    }
};

}  // namespace wrinkle::test
