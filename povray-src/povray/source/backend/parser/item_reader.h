// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file item_reader.h
/// Reads values of `tilt_lens { ... }`. Missing or wrong values throw tilt_lens::OpticsError.

#ifndef POVRAY_BACKEND_ITEM_READER_H
#define POVRAY_BACKEND_ITEM_READER_H

#include <string>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_items.h"

namespace pov
{

std::string Printed(const char* format, ...) __attribute__((format(printf, 1, 2)));

[[noreturn]] void Refuse(const char* format, ...) __attribute__((format(printf, 1, 2)));

extern const NumberRange kFinite, kPositive;

class ItemReader
{
  public:
    ItemReader(Parser& parser, const TiltLensItem& item) : parser(parser), item(item) {}

    Parser& parser;
    const TiltLensItem& item;

    void Read(TiltLensCamera& lens);

    double Number(const std::string& name, const NumberRange& range);
    tilt_lens::Vec3 Vector();
    /// A number or a vector; returns its length.
    int Numbers(const std::string& name, EXPRESS values);
    bool NextIsComma();
};

/// @name Read by special_items.cpp.
/// @{
void ReadShift(ItemReader& reader, TiltLensCamera& lens);
void ReadPrescription(ItemReader& reader, TiltLensCamera& lens);
void ReadFocalPlane(ItemReader& reader, TiltLensCamera& lens);
void ReadFocalPoints(ItemReader& reader, TiltLensCamera& lens);
void ReadSharpPoints(ItemReader& reader, TiltLensCamera& lens);
void ReadFocusOn(ItemReader& reader, TiltLensCamera& lens);
void ReadFocusAt(ItemReader& reader, TiltLensCamera& lens);
void ReadFocusPeaking(ItemReader& reader, TiltLensCamera& lens);
/// @}

} // namespace pov

#endif
