// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_words.h
/// The words of a `tilt_lens` block, and guesses at unknown words.

#ifndef POVRAY_BACKEND_TILT_LENS_WORDS_H
#define POVRAY_BACKEND_TILT_LENS_WORDS_H

#include <string>

namespace pov
{

class TiltLensParser;
struct TiltLensCamera;

/// An item of the block; its word is written nowhere else.
struct TiltLensItem
{
    const char* word;
    const char* family;  ///< words of its focus family, or NULL
    const char* distance; ///< the word itself if it states the distance of the focus, or NULL
    const char* example; ///< the word with a value
    void (*parse)(TiltLensParser& parser, const std::string& word, TiltLensCamera& lens);
};

/// In the order of messages.
struct TiltLensItems
{
    static const TiltLensItem kAll[35];
};

const TiltLensItem* FindTiltLensItem(const std::string& word);

/// The nearest item by Levenshtein distance, ignoring case.
const TiltLensItem& NearestTiltLensItem(const std::string& word);

/// True if a word was probably meant to begin the block.
bool LooksLikeTiltLens(const std::string& word);

std::string TiltLensItemNames();

/// True for an item of the camera that users expect inside the block.
bool IsCameraWord(const std::string& word);

} // namespace pov

#endif
