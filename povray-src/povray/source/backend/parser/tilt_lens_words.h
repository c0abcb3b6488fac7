// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_words.h
/// The words of a `tilt_lens` block, and what to say of a word that is none of them.

#ifndef POVRAY_BACKEND_TILT_LENS_WORDS_H
#define POVRAY_BACKEND_TILT_LENS_WORDS_H

#include <string>

namespace pov
{

class TiltLensParser;
struct TiltLensCamera;

/// An item of the block. This is the one place that has its word.
struct TiltLensItem
{
    const char* word;
    const char* family;  ///< words of its family of focus, or NULL
    const char* distance; ///< itself where it says how far away the focus lies, or NULL
    const char* example; ///< how it is written with its value
    /// Parses what stands behind the word.
    void (*parse)(TiltLensParser& parser, const std::string& word, TiltLensCamera& lens);
};

/// All items, in the order in which messages name them.
struct TiltLensItems
{
    static const TiltLensItem kAll[35];
};

/// The item of that spelling, or NULL.
const TiltLensItem* FindTiltLensItem(const std::string& word);

/// The item that takes the fewest edits (Levenshtein), upper and lower case alike.
const TiltLensItem& NearestTiltLensItem(const std::string& word);

/// Whether a word was probably meant to begin the block.
bool LooksLikeTiltLens(const std::string& word);

/// All items, for a message.
std::string TiltLensItemNames();

/// Whether people look for the word inside the block although it belongs to the camera around it.
bool IsCameraWord(const std::string& word);

} // namespace pov

#endif
