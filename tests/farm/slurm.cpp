#include "farm/slurm.h"

#include <fcntl.h>
#include <pwd.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "support/files.h"

namespace wrinkle::test {
namespace fs = std::filesystem;
namespace {

std::string short_host_name() {
    char name[256] = "";
    gethostname(name, sizeof name - 1);
    const std::string whole = name;
    return whole.substr(0, whole.find('.'));
}

// Writes a random key, readable by the owner only.
void write_key(const fs::path& file) {
    std::random_device random;
    std::string key(1024, 0);
    for (char& byte : key)
        byte = static_cast<char>(random());
    std::ofstream(file, std::ios::binary) << key;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace

Slurm::Slurm(const fs::path& folder) : folder_(folder) {
    for (const char* part : {"state", "spool"})
        fs::create_directories(folder / part);
    write_key(folder / "munge.key");
    configure();
    setenv("SLURM_CONF", (folder / "slurm.conf").c_str(), 1);
    const auto at = [&](const char* option, const char* name) {
        return std::string(option) + (folder_ / name).string();
    };
    start({"munged", "--foreground", "--force", at("--socket=", "munge.socket"),
           at("--key-file=", "munge.key"), at("--log-file=", "munge.log"),
           at("--pid-file=", "munge.pid"), at("--seed-file=", "munge.seed")});
    for (int i = 0; i < 1000 && !fs::exists(folder / "munge.socket"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    start({"slurmctld", "-D", "-c"});
    start({"slurmd", "-D", "-N", short_host_name()});
}

// Stops the daemons in reverse order: slurmctld signs off its node while munged still runs.
Slurm::~Slurm() {
    for (auto daemon = daemons_.rbegin(); daemon != daemons_.rend(); ++daemon) {
        kill(*daemon, SIGTERM);
        waitpid(*daemon, nullptr, 0);
    }
    unsetenv("SLURM_CONF");
}

std::string Slurm::log() const {
    std::string text;
    for (const char* name : {"munged.log", "slurmctld.log", "slurmd.log"})
        text += std::string(name) + ":\n" + bytes_of(folder_ / name);
    return text;
}

void Slurm::start(const std::vector<std::string>& command) {
    std::vector<char*> words;
    for (const std::string& word : command)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const fs::path log = folder_ / (command[0] + ".log");
    const pid_t child = fork();
    if (child != 0) {
        daemons_.push_back(child);
        return;
    }
    const int file = open(log.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
    for (const int standard : {0, 1, 2})
        dup2(file, standard);
    setenv("PATH", ("/usr/sbin:/sbin:" + std::string(getenv("PATH"))).c_str(), 1);
    execvp(words[0], words.data());
    _exit(127);
}

// The ports derive from the process id, so that two test clusters do not collide.
void Slurm::configure() const {
    const passwd* user = getpwuid(geteuid());
    const std::string name = user ? user->pw_name : "root", host = short_host_name();
    const int port = 20000 + getpid() % 20000 / 2 * 2;
    std::ofstream out(folder_ / "slurm.conf");
    out << "ClusterName=test\nSlurmctldHost=" << host << "(127.0.0.1)\nSlurmctldPort=" << port
        << "\nSlurmdPort=" << port + 1 << "\nSlurmUser=" << name << "\nSlurmdUser=" << name
        << "\nAuthInfo=socket=" << (folder_ / "munge.socket").string()
        << "\nStateSaveLocation=" << (folder_ / "state").string()
        << "\nSlurmdSpoolDir=" << (folder_ / "spool").string()
        << "\nSlurmctldPidFile=" << (folder_ / "slurmctld.pid").string()
        << "\nSlurmdPidFile=" << (folder_ / "slurmd.pid").string()
        << "\nProctrackType=proctrack/pgid\nTaskPlugin=task/none"
           "\nJobAcctGatherType=jobacct_gather/none\nMailProg=/bin/true"
           "\nSelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\nNodeName="
        << host << " NodeAddr=127.0.0.1 CPUs="
        << std::max(1U, std::min(2U, std::thread::hardware_concurrency()))
        << " State=UNKNOWN\nPartitionName=all Nodes=" << host << " Default=YES State=UP\n";
}

}  // namespace wrinkle::test
