#include "graph/order.h"

#include <span>

#include "base/text.h"

namespace wrinkle {
namespace {

struct BackEdge {
    uint32_t node;
    uint32_t input;
    std::vector<uint32_t> path;  // from the node read again, reader to read; shortened
    size_t length = 0;           // nodes of the complete cycle
};

struct Walk {
    std::vector<uint32_t> order;
    std::vector<BackEdge> closing;
};

constexpr size_t shown = 8;                                    // nodes of a cycle in a diagnostic
constexpr size_t max_cycles = Diagnostics::default_limit + 1;  // further cycles are not recorded

// Depth-first search with an explicit stack.
class Walker {
public:
    Walker(const Document& document, const Wires& wires)
        : wires_(wires), state_(document.nodes.size(), State::unseen) {}

    Walk run() {
        walk_.order.reserve(state_.size());
        for (uint32_t i = 0; i < state_.size(); ++i)
            if (state_[i] == State::unseen) walk_from(i);
        return std::move(walk_);
    }

private:
    enum class State : uint8_t { unseen, open, done };
    struct Frame {
        uint32_t node;
        uint32_t next_input;
    };

    void walk_from(uint32_t root) {
        enter(root);
        while (!stack_.empty()) {
            Frame& frame = stack_.back();
            if (frame.next_input == wires_.of(frame.node).size())
                leave();
            else
                follow(frame.node, frame.next_input++);
        }
    }

    void enter(uint32_t node) {
        state_[node] = State::open;
        stack_.push_back({node, 0});
    }

    void leave() {
        const uint32_t node = stack_.back().node;
        stack_.pop_back();
        state_[node] = State::done;
        walk_.order.push_back(node);
    }

    void follow(uint32_t node, uint32_t input) {
        const uint32_t target = wires_.of(node)[input];
        if (target == Wires::none) return;
        if (state_[target] == State::unseen)
            enter(target);
        else if (state_[target] == State::open && walk_.closing.size() < max_cycles)
            walk_.closing.push_back(cycle(node, input, target));
    }

    BackEdge cycle(uint32_t node, uint32_t input, uint32_t target) const {
        size_t begin = stack_.size() - 1;
        while (stack_[begin].node != target)
            --begin;
        BackEdge closing{node, input, {}, stack_.size() - begin};
        for (size_t i = begin; i < stack_.size(); ++i)
            if (i < begin + shown / 2 || i + shown / 2 >= stack_.size())
                closing.path.push_back(stack_[i].node);
        return closing;
    }

    const Wires& wires_;
    std::vector<State> state_;
    std::vector<Frame> stack_;
    Walk walk_;
};

std::string cycle_text(const Document& document, const BackEdge& closing) {
    const std::vector<uint32_t>& path = closing.path;
    std::string text = "the wires form a cycle: ";
    for (size_t i = 0; i < path.size(); ++i) {
        if (i == shown / 2 && closing.length > path.size())
            text += "... (" + std::to_string(closing.length - path.size()) + " more) reads ";
        text += "'" + document.nodes[path[i]]->id + "' reads ";
    }
    return text + "'" + document.nodes[path[0]]->id + "'";
}

// Suggests names, within a budget so that a large graph with many errors is still read quickly.
template <class T>
class Names {
public:
    explicit Names(const Table<T>& table) : table_(table) {}

    std::string remedy(std::string_view word, const char* otherwise) {
        if (table_.size() > budget_) return otherwise;
        budget_ -= table_.size();
        if (names_.empty())
            for (const T& entry : table_)
                names_.emplace_back(table_key(entry));
        return did_you_mean(word, names_, otherwise);
    }

private:
    const Table<T>& table_;
    std::vector<std::string> names_;
    size_t budget_ = 200'000;
};

class Checker {
public:
    Checker(const Document& document, const Wires& wires, Diagnostics& diagnostics)
        : document_(document),
          diagnostics_(diagnostics),
          wires_(wires),
          ids_(document.nodes),
          inputs_(document.inputs) {}

    void run() {
        bool forward = false;  // a node reads itself or a later node: required for a cycle
        for (size_t n = 0; n < document_.nodes.size(); ++n) {
            const Node& node = *document_.nodes[n];
            const auto read = wires_.of(n);
            for (size_t i = 0; i < read.size(); ++i) {
                if (read[i] == Wires::none) check_port(node, node.inputs[i]);
                forward |= read[i] != Wires::none && read[i] >= n;
            }
        }
        for (const Output& output : document_.outputs)
            check(output.from.link, [&](std::string message, std::string expected) {
                return diagnose(document_, output, std::move(message), std::move(expected));
            });
        if (forward) report_cycles();
    }

private:
    void check_port(const Node& node, const Input& input) {
        check(input.link, [&](std::string message, std::string expected) {
            return diagnose_port(document_, node, input.port, std::move(message),
                                 std::move(expected));
        });
    }

    template <class Diagnose>
    void check(const Link& link, Diagnose diagnose_here) {
        const bool lost_node = link.is_node() && !document_.find(link.node);
        const bool lost_input = link.is_input() && !document_.inputs.find(link.port);
        if (!lost_node && !lost_input) return;
        if (diagnostics_.dropped() > 0) return diagnostics_.add({});  // only counted
        if (lost_node)
            diagnostics_.add(diagnose_here("there is no node '" + link.node + "'",
                                           ids_.remedy(link.node, "expected the id of a node")));
        else
            diagnostics_.add(
                diagnose_here("the graph has no input '" + link.port + "'",
                              inputs_.remedy(link.port, "declare it under \"inputs\"")));
    }

    void report_cycles() {
        for (const BackEdge& closing : Walker(document_, wires_).run().closing) {
            const Node& node = *document_.nodes[closing.node];
            diagnostics_.add(diagnose_port(document_, node, node.inputs[closing.input].port,
                                           cycle_text(document_, closing),
                                           "remove one of these wires"));
        }
    }

    const Document& document_;
    Diagnostics& diagnostics_;
    const Wires& wires_;
    Names<NodePtr> ids_;
    Names<GraphInput> inputs_;
};

}  // namespace

std::vector<uint32_t> evaluation_order(const Document& document) {
    const Wires wires(document);
    return Walker(document, wires).run().order;
}

void check_links(const Document& document, Diagnostics& diagnostics) {
    check_links(document, Wires(document), diagnostics);
}

void check_links(const Document& document, const Wires& wires, Diagnostics& diagnostics) {
    Checker(document, wires, diagnostics).run();
}

}  // namespace wrinkle
