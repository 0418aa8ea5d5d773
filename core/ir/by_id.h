// Things beside some ids of a module, as a frame beside the id of an opaque frame. Part of the
// expansion pass.
//
// Things of several kinds share one list of places, as an id has one thing at most. What is taken
// makes room for the next, so where most are taken soon a long module needs few at a time.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ir/inst.h"

namespace wrinkle {

using Places = std::vector<uint32_t>;  // by Id; 0 where there is none

template <class T>
class ById {
public:
    explicit ById(Places& places) : places_(places) {}
    void set(Id id, T thing) {
        if (free_.empty()) {
            things_.push_back(std::move(thing));
            places_[id] = static_cast<uint32_t>(things_.size());
        } else {
            places_[id] = free_.back();
            free_.pop_back();
            things_[places_[id] - size_t{1}] = std::move(thing);
        }
    }
    const T& at(Id id) const { return things_.at(places_[id] - size_t{1}); }
    const T* find(Id id) const { return places_[id] ? &at(id) : nullptr; }
    // For the last time.
    T take(Id id) {
        free_.push_back(std::exchange(places_[id], 0));
        return std::move(things_.at(free_.back() - size_t{1}));
    }

private:
    Places& places_;  // one more than the index
    std::vector<T> things_;
    std::vector<uint32_t> free_;  // places whose thing was taken
};

}  // namespace wrinkle
