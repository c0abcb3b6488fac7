// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <charconv>
#include <sstream>

#include "tilt_lens/glass/prescription_rows.h"

namespace tilt_lens
{

namespace
{

const char* const kRow = "four numbers, radius, thickness, index of refraction and clear diameter, and may have a fifth, the Abbe number";

double NumberOf(const std::string& word, int line)
{
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const std::from_chars_result read = std::from_chars(begin, end, value);
    if (read.ec != std::errc() || read.ptr != end)
        throw PrescriptionError(line, "'" + Shown(word) + "' where a number should be. A row has " + std::string(kRow) +
                                          "; '#' begins a comment.");
    return value;
}

} // namespace

std::vector<ReadRow> ReadPbrtRows(const std::string& text)
{
    std::vector<ReadRow> rows;
    std::istringstream stream(text);
    std::string written;
    for (int line = 1; std::getline(stream, written); line++)
    {
        std::istringstream words(written.substr(0, written.find('#')));
        std::vector<double> numbers;
        for (std::string word; words >> word;)
            numbers.push_back(NumberOf(word, line));
        if (numbers.empty())
            continue;
        if (numbers.size() != 4 && numbers.size() != 5)
            throw PrescriptionError(line, std::to_string(numbers.size()) + " numbers. A row has " + kRow + ".");
        ReadRow read;
        read.line = line;
        read.row.radius = numbers[0];
        read.row.thickness = numbers[1];
        read.row.index = numbers[2];
        read.row.diameter = numbers[3];
        if (numbers.size() == 5)
            read.row.abbe = numbers[4];
        // pbrt writes air as 0 or 1; radius 0 and index 0 is the stop
        read.stop = numbers[0] == 0.0 && numbers[2] == 0.0;
        if (read.row.index == 0.0)
            read.row.index = 1.0;
        rows.push_back(read);
    }
    return rows;
}

} // namespace tilt_lens
