// The keys of the objects of a scene file. An object is described once, by describe(Fields&, Object&), which names
// its keys: with that it is read, written, and its unknown keys are refused.
#pragma once

#include "demos/base/text/json_reader.h"
#include "engine/constraints/joint_constraints.h"

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pushfactor::demos {

using Keys = std::vector<std::string>;

class Fields;

template <typename Object>
concept Described = requires(Fields& fields, Object& object) {
    describe(fields, object);
};

template <typename Value>
requires std::is_arithmetic_v<Value> Json to_json(Value value) {
    return value;
}
inline Json to_json(const std::string& text) {
    return text;
}
inline Json to_json(const engine::Vector3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}
inline Json to_json(const engine::Quaternion& q) {
    return Json::array({q.w(), q.x(), q.y(), q.z()});
}
inline Json to_json(const std::pair<std::string, std::string>& pair) {
    return Json::array({pair.first, pair.second});
}
inline Json to_json(const engine::AngleLimits& limits) {
    return Json::array({limits.low, limits.high});
}
inline Json to_json(const engine::Lambda& lambda) {
    return Json::array({lambda.first, lambda.last});
}
template <Described Object>
Json to_json(Object object);
template <typename Value>
Json to_json(const std::optional<Value>& value) {
    return to_json(*value);
}
template <typename Entry>
Json to_json(const std::vector<Entry>& list) {
    Json json = Json::array();
    for (const Entry& entry : list) json.push_back(to_json(entry));
    return json;
}

// Whether a value need not be written.
inline bool says_nothing(const engine::Vector3& vector) {
    return vector.isZero(0.0);
}
template <typename Value>
bool says_nothing(const Value& value) {
    return value == Value{};
}
template <typename Value>
bool says_nothing(const std::optional<Value>& value) {
    return !value;
}
template <typename Entry>
bool says_nothing(const std::vector<Entry>& list) {
    return list.empty();
}

class Fields {
  public:
    explicit Fields(const JsonReader& from) : from_(&from) {}
    explicit Fields(Json& to) : to_(&to) {}
    explicit Fields(Keys& names) : names_(&names) {}

    // Whether only the keys are listed: all that an object may have, of whatever kind it is.
    bool are_listed() const { return names_ != nullptr; }

    // A key that must be given. `read`: a member of JsonReader, or a function of one.
    template <typename Value, typename Read>
    void must(const char* key, Value& value, const Read& read) {
        if (names_) names_->emplace_back(key);
        if (from_) value = std::invoke(read, from_->at(key));
        if (to_) (*to_)[key] = to_json(value);
    }
    // One that may be left out, and is always written.
    template <typename Value, typename Read>
    void may(const char* key, Value& value, const Read& read) {
        if (!from_ || from_->has(key)) must(key, value, read);
    }
    // One that is written only if it says something.
    template <typename Value, typename Read>
    void may(const char* key, Value& value, const Read& read, bool says_something) {
        if (!to_ || says_something) may(key, value, read);
    }
    template <typename Value, typename Read>
    void if_any(const char* key, Value& value, const Read& read) {
        may(key, value, read, !says_nothing(value));
    }
    // One of some words, of which the first is not written.
    template <typename Value, std::size_t n>
    void word(const char* key, Value& value, const std::array<std::pair<const char*, Value>, n>& words) {
        std::string word, allowed;
        for (const auto& [name, meaning] : words) {
            if (meaning == value) word = name;
            allowed += (allowed.empty() ? "one of " : ", ") + std::string(name);
        }
        may(key, word, &JsonReader::string, value != words.front().second);
        const auto found =
            std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.first == word; });
        if (found == words.end()) from_->at(key).refuse(allowed);
        value = found->second;
    }

  private:
    const JsonReader* from_ = nullptr;
    Json* to_ = nullptr;
    Keys* names_ = nullptr;
};

template <typename Object>
const Keys& keys_of() {
    static const Keys keys = [] {
        Keys names;
        Fields fields(names);
        Object object{};
        describe(fields, object);
        return names;
    }();
    return keys;
}

template <Described Object>
Json to_json(Object object) {
    Json json = Json::object();
    Fields fields(json);
    describe(fields, object);
    return json;
}

// The keys of objects that are of one of several kinds.
inline Keys joined(std::initializer_list<Keys> lists) {
    Keys all;
    for (const Keys& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

template <typename Object>
Object read_object(const JsonReader& json) {
    json.require_object(keys_of<Object>());
    Object object{};
    Fields fields(json);
    describe(fields, object);
    return object;
}

// The entries of an array. `read`: a function of one.
template <typename Read>
auto read_each(const JsonReader& json, const Read& read) {
    std::vector<decltype(read(json))> list;
    for (const JsonReader& entry : json.elements()) list.push_back(read(entry));
    return list;
}

inline auto between(double low, double high) {
    return [low, high](const JsonReader& json) { return json.number(low, high); };
}

inline std::string read_name(const JsonReader& json) {
    std::string name = json.string();
    if (name.empty()) json.refuse("a name of at least one letter");
    return name;
}

inline void refuse_if_given(const JsonReader& json, const Keys& keys, const std::string& allowed) {
    for (const std::string& key : keys) {
        if (json.has(key)) json.at(key).refuse(allowed);
    }
}

}  // namespace pushfactor::demos
