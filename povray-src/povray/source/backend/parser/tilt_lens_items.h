// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_items.h
/// The table of the items of `tilt_lens { ... }`: the one place to add an item. Tests compare it with manual, editors and the fuzzer's grammar.

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
    std::string message;  ///< states the range and a remedy, behind the item's word and its value
    bool whole = false;
};

struct ItemNumber
{
    NumberRange range;
    void (*set)(TiltLensCamera& lens, double value);
    const char* name = NULL;  ///< in messages; NULL: the item's word
};

struct TiltLensItem
{
    const char* word;
    const char* values;  ///< as in the manual, by their units or kinds
    const char* example;  ///< of the values
    std::vector<ItemNumber> numbers;  ///< all but the first are optional
    void (*read)(ItemReader& reader, TiltLensCamera& lens) = NULL;  ///< for values that are not these numbers
    std::optional<tilt_lens::FocusFamily> family = {};
    bool statesDistance = false;  ///< of the focus

    /// The item with values.
    std::string Example() const;
};

/// In the order of messages.
extern const std::vector<TiltLensItem> kTiltLensItems;

/// NULL: there is none.
const TiltLensItem* FindTiltLensItem(const std::string& word);

/// The nearest item by Levenshtein distance, ignoring case.
const TiltLensItem& NearestTiltLensItem(const std::string& word);

/// True if a word was probably meant to begin the block.
bool LooksLikeTiltLens(const std::string& word);

std::string TiltLensItemNames();

/// True for an item of the camera that users expect inside the block.
bool IsCameraWord(const std::string& word);

}  // namespace pov

#endif
