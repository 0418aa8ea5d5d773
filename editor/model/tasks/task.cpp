#include "editor/model/tasks/task.h"

#include <utility>

#include "base/text.h"
#include "editor/model/session.h"
#include "editor/model/words.h"

namespace wrinkle::editor {

Task::Task(TaskSpec order, std::function<void()> wake)
    : order_(std::move(order)), thread_([this, wake = std::move(wake)] {
          outcome_ = order_.work(progress_);
          ended_ = true;
          if (wake) wake();
      }) {}

Task::~Task() {
    cancel();
    if (thread_.joinable()) thread_.join();
}

TaskOutcome Task::outcome() {
    if (thread_.joinable()) thread_.join();
    return outcome_;
}

std::string progress_words(uint64_t done, uint64_t total, double seconds, const std::string& unit) {
    if (total <= 1) return {};
    if (unit.empty()) return grouped(done) + " of " + grouped(total) + " steps";
    const auto now = static_cast<double>(done), all = static_cast<double>(total);
    const std::string part = std::to_string(done * 100 / total) + " %";
    if (done == 0 || !(seconds > 0)) return part;
    const double rate = now / seconds;
    return part + ", " + rough_count(rate) + unit + "/s, about " +
           rough_duration((all - now) / rate) + " left";
}

bool start_task(Session& session, TaskSpec order) {
    Tasks& tasks = session.tasks;
    if (tasks.running) {
        session.status = tasks.running->order().name + " is not done yet.";
        return false;
    }
    tasks.failed.clear();
    tasks.warnings = Diagnostics();
    tasks.warnings_of = session.path;
    session.status = order.name;
    tasks.running = std::make_unique<Task>(std::move(order), tasks.wake);
    return true;
}

void cancel_task(Session& session) {
    if (session.tasks.running) session.tasks.running->cancel();
    session.tasks.failed.clear();
}

void try_task_again(Session& session) {
    const auto again = std::exchange(session.tasks.again, {});
    session.tasks.failed.clear();
    if (again) again();
}

void poll_tasks(Session& session) {
    Tasks& tasks = session.tasks;
    if (!tasks.running || !tasks.running->ended()) return;
    if (tasks.running->order().then && session.question.open()) return;
    TaskOutcome outcome = tasks.running->outcome();
    const TaskSpec& order = tasks.running->order();
    if (outcome.good || !tasks.running->cancelled()) {
        session.status = outcome.sentence;
        if (!outcome.good) tasks.failed = outcome.sentence;
        tasks.warnings = std::move(outcome.warnings);
    } else {
        session.status = order.name + " was cancelled. Nothing was written.";
    }
    tasks.again = order.again;
    const auto then = order.then;
    tasks.running.reset();
    if (outcome.good && then) then(session);
}

}  // namespace wrinkle::editor
