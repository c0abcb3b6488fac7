// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file message_order_test.cpp
/// The console prints messages in order, even within one millisecond.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "vfe.h"

namespace
{

class StandingClock : public vfePlatform::vfeUnixSession
{
  public:
    StandingClock() { Reset(); }
    POV_LONG GetTimestamp() const override { return 0; }

    void Text(const char* text) { AppendStreamMessage(mInformation, text); }
    void Status(const char* text) { AppendStatusMessage(text); }
    void Warning(const char* text) { AppendWarningMessage(text); }

    std::vector<std::string> Printed()
    {
        std::vector<std::string> texts;
        MessageType type;
        for (std::string text; GetNextCombinedMessage(type, text);)
            texts.push_back(text);
        return texts;
    }
};

using Texts = std::vector<std::string>;

TEST(MessageOrder, WarningFollowsItsPlaceAndProgressFollowsBoth)
{
    StandingClock session;
    session.Text("File: scene.pov  Line: 2");
    session.Text("Render Warning: a text\n of two lines");
    session.Status("Rendered 48 of 48 pixels");
    session.Text("Render Statistics");
    EXPECT_EQ(session.Printed(), (Texts{"File: scene.pov  Line: 2", "Render Warning: a text", " of two lines", "Rendered 48 of 48 pixels",
                                        "Render Statistics"}));
}

TEST(MessageOrder, KindsOfMessagesKeepTheirOrder)
{
    StandingClock session;
    session.Status("1");
    session.Text("2");
    session.Warning("3");
    session.Status("4");
    session.Warning("5");
    session.Text("6");
    EXPECT_EQ(session.Printed(), (Texts{"1", "2", "3", "4", "5", "6"}));
}

} // namespace
