// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file json_value.h
/// JSON whose values know their lines, for errors.

#ifndef TILT_LENS_JSON_VALUE_H
#define TILT_LENS_JSON_VALUE_H

#include <string>
#include <vector>

namespace tilt_lens
{

struct JsonValue
{
    enum class Kind
    {
        kNull,
        kBoolean,
        kNumber,
        kText,
        kList,
        kObject
    };

    Kind kind = Kind::kNull;
    int line = 0;                    ///< first line, from 1
    std::string name;
    double number = 0.0;
    std::string text;
    std::vector<JsonValue> members;

    bool Is(Kind other) const { return kind == other; }

    /// Null if the member or its value is missing.
    const JsonValue* Find(const std::string& wanted) const;

    std::string Words() const;
};

/// @throws PrescriptionError  not JSON, or nested too deeply
JsonValue ReadJson(const std::string& text);

} // namespace tilt_lens

#endif
