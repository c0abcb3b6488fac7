// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_items.h
/// The items of `tilt_lens { ... }`. Tests compare them with manual, editors and fuzzer.

#ifndef POVRAY_BACKEND_TILT_LENS_ITEMS_H
#define POVRAY_BACKEND_TILT_LENS_ITEMS_H

#include <optional>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/scene/tilt_lens_camera.h"

namespace pov
{

class ItemReader;

struct NumberRange
{
    double least, most;
    std::string message;  ///< range and remedy; follows word and value
    bool whole = false;
};

struct ItemNumber
{
    NumberRange range;
    void (*set)(TiltLensCamera& lens, double value);
    const char* name = NULL;  ///< NULL: the item's word
};

struct TiltLensItem
{
    const char* word;
    const char* values;  ///< for the manual, by units or types
    const char* example;
    std::vector<ItemNumber> numbers;  ///< all but the first are optional
    void (*read)(ItemReader& reader, TiltLensCamera& lens) = NULL;
    std::optional<tilt_lens::FocusFamily> family = {};
    bool statesDistance = false;

    std::string Example() const;
};

extern const std::vector<TiltLensItem> kTiltLensItems;

const TiltLensItem* FindTiltLensItem(const std::string& word);

/// By Levenshtein distance, ignoring case.
const TiltLensItem& NearestTiltLensItem(const std::string& word);

bool LooksLikeTiltLens(const std::string& word);

std::string TiltLensItemNames();

/// Users expect these inside the block.
bool IsCameraWord(const std::string& word);

} // namespace pov

#endif
