// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file json_value.h
/// JSON whose values know their lines, so that an error can name the line of what is wrong.

#ifndef TILT_LENS_JSON_VALUE_H
#define TILT_LENS_JSON_VALUE_H

#include <string>
#include <vector>

namespace tilt_lens
{

struct JsonValue
{
    enum class Kind { kNull, kBoolean, kNumber, kText, kList, kObject };

    Kind kind = Kind::kNull;
    int line = 0;                    ///< of the file, from 1, in which it begins
    std::string name;                ///< of a member of an object
    double number = 0.0;
    std::string text;
    std::vector<JsonValue> members;  ///< of a list or an object

    bool Is(Kind other) const { return kind == other; }

    /// A member that is not null, or NULL.
    const JsonValue* Find(const std::string& wanted) const;

    /// The value in words, for an error.
    std::string Words() const;
};

/// @throws PrescriptionError  where the text is no JSON, or is nested deeper than any lens
JsonValue ReadJson(const std::string& text);

} // namespace tilt_lens

#endif
