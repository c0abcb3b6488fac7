// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/json_value.h"

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/glass/prescription_rows.h"

namespace tilt_lens
{

namespace
{

using Kind = JsonValue::Kind;

/// A collection of lenses has five levels.
constexpr std::size_t kDeepest = 64;

/// The parser reports a number one character late, so the line is that of the last character read.
struct LineCounter
{
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    int* line;
    bool* lineEnded;

    reference operator*() const { return *at; }
    bool operator==(const LineCounter& other) const { return at == other.at; }
    bool operator!=(const LineCounter& other) const { return at != other.at; }
    LineCounter& operator++()
    {
        *line += *lineEnded;
        *lineEnded = *at++ == '\n';
        return *this;
    }
    LineCounter operator++(int)
    {
        const LineCounter before = *this;
        ++*this;
        return before;
    }
};

class Builder : public nlohmann::json_sax<nlohmann::json>
{
  public:
    Builder(const std::string& itsText, const int& itsLine) : text(itsText), line(itsLine) {}

    JsonValue root;

    bool null() override { return Add(Kind::kNull); }
    bool boolean(bool value) override { return Add(Kind::kBoolean, value); }
    bool number_integer(number_integer_t value) override { return Add(Kind::kNumber, double(value)); }
    bool number_unsigned(number_unsigned_t value) override { return Add(Kind::kNumber, double(value)); }
    bool number_float(number_float_t value, const string_t&) override { return Add(Kind::kNumber, value); }
    bool string(string_t& value) override { return Add(Kind::kText, 0.0, value); }
    bool binary(binary_t&) override { return Add(Kind::kNull); }
    bool key(string_t& value) override
    {
        name = value;
        return true;
    }
    bool start_object(std::size_t) override { return Open(Kind::kObject); }
    bool start_array(std::size_t) override { return Open(Kind::kList); }
    bool end_object() override { return Close(); }
    bool end_array() override { return Close(); }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override
    {
        const auto end = text.begin() + std::ptrdiff_t(std::min(position > 0 ? position - 1 : 0, text.size()));
        std::string words = error.what();
        // "[json.exception...] parse error at line 1, column 2: words"
        const std::size_t column = words.find("column ");
        const std::size_t colon = words.find(": ", column == std::string::npos ? 0 : column);
        words.erase(0, colon == std::string::npos ? 0 : colon + 2);
        throw PrescriptionError(1 + int(std::count(text.begin(), end, '\n')), "no JSON: " + words + ". Mend the file, or take another.");
    }

  private:
    const std::string& text;
    const int& line;
    std::string name;
    std::vector<JsonValue*> open;

    bool Add(Kind kind, double number = 0.0, const std::string& words = "")
    {
        JsonValue value;
        value.kind = kind;
        value.line = line;
        value.name.swap(name);
        value.number = number;
        value.text = words;
        if (open.empty())
            root = value;
        else
            open.back()->members.push_back(value);
        return true;
    }

    bool Open(Kind kind)
    {
        if (open.size() == kDeepest)
            throw PrescriptionError(line, "lists and objects in each other, more than " + std::to_string(kDeepest) +
                                              " deep. A lens has "
                                              "five; is it the right file?");
        Add(kind);
        open.push_back(open.empty() ? &root : &open.back()->members.back());
        return true;
    }

    bool Close()
    {
        open.pop_back();
        return true;
    }
};

} // namespace

const JsonValue* JsonValue::Find(const std::string& wanted) const
{
    for (const JsonValue& member : members)
        if (kind == Kind::kObject && member.name == wanted)
            return member.kind == Kind::kNull ? nullptr : &member;
    return nullptr;
}

std::string JsonValue::Words() const
{
    switch (kind)
    {
        case Kind::kNull: return "null";
        case Kind::kBoolean: return number != 0.0 ? "true" : "false";
        case Kind::kNumber: return Number(number);
        case Kind::kText: return "the text '" + Shown(text) + "'";
        case Kind::kList: return "a list";
        case Kind::kObject: break;
    }
    return "an object";
}

JsonValue ReadJson(const std::string& text)
{
    int line = 1;
    bool lineEnded = false;
    Builder builder(text, line);
    const char* const begin = text.data();
    nlohmann::json::sax_parse(LineCounter{begin, &line, &lineEnded}, LineCounter{begin + text.size(), &line, &lineEnded}, &builder);
    return std::move(builder.root);
}

} // namespace tilt_lens
