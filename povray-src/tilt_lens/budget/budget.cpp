// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/budget/budget.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/samples/sequence.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

namespace
{

/// One in so many blocks takes part in the trials: more if they would be fewer than kTrialBlocks.
constexpr std::size_t kTrialStride = 16, kLeastTrialStride = 8, kTrialBlocks = 32;

} // namespace

BudgetPilot::BudgetPilot(const SamplingLimits& given, std::uint32_t itsWidth, std::uint32_t itsHeight, double itsBudget,
                         double recordBytes) :
    budget(itsBudget),
    width(itsWidth),
    height(itsHeight),
    columns((width + Settings::blockSide - 1) / Settings::blockSide),
    rows((height + Settings::blockSide - 1) / Settings::blockSide),
    limits(given),
    blocks(std::size_t(columns) * rows),
    records(blocks.size())
{
    all = WithNeighbours(ChosenPlaces(recordBytes));
    const std::size_t stride = std::clamp(all.counted.size() / kTrialBlocks, kLeastTrialStride, kTrialStride);
    std::vector<std::size_t> places;
    for (std::size_t i = std::min(stride / 2, all.counted.size() - 1); i < all.counted.size(); i += stride)
        places.push_back(all.counted[i]);
    few = WithNeighbours(places);
    for (const std::size_t place : all.counted)
        allowed += budget * PixelsOf(place).Size();
    for (const std::size_t place : all.looked)
        records[place] = std::make_unique<SampleRecord>(PixelsOf(place), limits.settings.mostSentSamples);
    BeginRound(*NextTrialVariance(trials, budget, limits.FirstRound()));
}

Area BudgetPilot::PixelsOf(std::size_t place) const
{
    const std::uint32_t side = Settings::blockSide, left = place % columns * side, top = place / columns * side;
    return {left, top, std::min(side, width - left), std::min(side, height - top)};
}

/// Null where no block is looked at.
Block::Neighbours BudgetPilot::NeighboursOf(std::size_t place) const
{
    Block::Neighbours neighbours{};
    const std::int64_t column = place % columns, row = place / columns;
    for (int i = 0; i < 9; i++)
    {
        const std::int64_t x = column + i % 3 - 1, y = row + i / 3 - 1;
        if (x >= 0 && x < columns && y >= 0 && y < rows)
            neighbours[i] = blocks[y * columns + x].get();
    }
    return neighbours;
}

/// All blocks if `recordBytes` suffice; else a random one of each equally large group of neighbours.
std::vector<std::size_t> BudgetPilot::ChosenPlaces(double recordBytes) const
{
    const double pixels = Settings::blockSide * Settings::blockSide,
                 ofBlock = pixels * SampleRecord::BytesOf(budget, limits.settings.mostSentSamples);
    const double ofNeighbours = 8.0 * pixels * SampleRecord::BytesOf(limits.FirstRound(), limits.settings.mostSentSamples);
    const std::size_t number = blocks.size();
    const bool whole = number * ofBlock <= recordBytes;
    const std::size_t wanted = whole ? number : std::min(number, std::max<std::size_t>(2, recordBytes / (ofBlock + ofNeighbours)));

    // bands as high as a group is wide, column by column
    const std::size_t high = std::max<std::size_t>(1, std::lround(std::sqrt(double(number) / wanted)));
    std::vector<std::size_t> order, chosenPlaces;
    for (std::size_t top = 0; top < rows; top += high)
        for (std::size_t column = 0; column < columns; column++)
            for (std::size_t row = top; row < std::min<std::size_t>(rows, top + high); row++)
                order.push_back(row * columns + column);
    for (std::size_t i = 0; i < wanted; i++)
    {
        const double within = whole ? 0.0 : PixelHash(std::uint32_t(i), 0, 0, 0xB4D6E7) * 0x1p-32;
        chosenPlaces.push_back(order[std::size_t((i + within) * number / wanted)]);
    }
    return chosenPlaces;
}

BudgetPilot::Blocks BudgetPilot::WithNeighbours(const std::vector<std::size_t>& places) const
{
    Blocks found{places, {}};
    std::vector<bool> needed(blocks.size());
    for (const std::size_t place : places)
    {
        const std::int64_t column = place % columns, row = place / columns;
        for (std::int64_t y = std::max<std::int64_t>(0, row - 1); y <= std::min<std::int64_t>(rows - 1, row + 1); y++)
            for (std::int64_t x = std::max<std::int64_t>(0, column - 1); x <= std::min<std::int64_t>(columns - 1, column + 1); x++)
                needed[y * columns + x] = true;
    }
    for (std::size_t place = 0; place < blocks.size(); place++)
        if (needed[place])
            found.looked.push_back(place);
    return found;
}

void BudgetPilot::BeginRound(double variance)
{
    limits.variance = variance;
    for (const std::size_t place : Sampled().looked)
        blocks[place] = std::make_unique<Block>(PixelsOf(place), width, height, limits.settings);
    step = 0;
    tasks.BeginRound(Places().size());
}

std::optional<BudgetPilot::Task> BudgetPilot::NextTask()
{
    const std::optional<std::size_t> number = tasks.Next();
    return number ? Task{*number, Places()[*number]} : std::optional<Task>();
}

void BudgetPilot::Take(const Task& task, const Tracer& trace)
{
    SampleRecord& record = *records[task.block];
    const Tracer recorded([&](const SampleRun& run, SampleResult* results) { record.GetOrTrace(run, results, trace); });
    const auto work = [&]
    {
        const std::uint64_t before = record.Samples();
        blocks[task.block]->TakeStep(step, NeighboursOf(task.block), limits, recorded);
        traced += record.Samples() - before;
    };
    tasks.Take(task.number, work, [this] { EndStep(); });
}

double BudgetPilot::Progress() const
{
    return std::min(1.0, traced / allowed);
}

void BudgetPilot::EndStep()
{
    if (++step == Block::kSteps)
        EndRound();
    else
        tasks.BeginRound(Places().size());
}

void BudgetPilot::EndRound()
{
    double samples = 0.0;
    for (const std::size_t place : all.counted)
        samples += records[place]->Samples();
    recorded = samples / (double(width) * height);
    (trying ? trials : rounds).push_back(Measure());
    for (std::unique_ptr<Block>& block : blocks)
        block.reset();
    if (trying)
    {
        if (const std::optional<double> next = NextTrialVariance(trials, budget, limits.FirstRound()))
            return BeginRound(*next);
        trying = false;
    }
    if (const std::optional<double> next = NextVariance(trials, rounds, recorded, budget, limits.FirstRound()))
        return BeginRound(*next);
    if (const BudgetRound* best = BestRound(rounds, recorded, budget))
        chosen = *best;
    else  // the pixels' first rounds alone keep the budget
    {
        limits.max = limits.FirstRound();
        const BudgetRound& last = (rounds.empty() ? trials : rounds).back();
        chosen = {UsualVariance(budget), double(limits.max), 0.0, limits.max * last.used / last.samples};
    }
    limits.variance = chosen.variance;
    tasks.BeginRound(0);
}

BudgetRound BudgetPilot::Measure() const
{
    BudgetRound round;
    round.variance = limits.variance;
    const std::vector<std::size_t>& counted = Sampled().counted;
    double pixels = 0.0, samples = 0.0, differences = 0.0, before = 0.0;
    for (std::size_t i = 0; i < counted.size(); i++)
    {
        const Area area = PixelsOf(counted[i]);
        double ofBlock = 0.0;
        for (std::uint32_t y = area.top; y < area.Bottom(); y++)
            for (std::uint32_t x = area.left; x < area.Right(); x++)
                ofBlock += blocks[counted[i]]->ResultOf(x, y).samples;
        pixels += area.Size();
        samples += ofBlock;
        const double mean = ofBlock / area.Size();
        differences += i > 0 ? (mean - before) * (mean - before) : 0.0;
        before = mean;
    }
    round.samples = samples / pixels;
    round.used = samples / (double(width) * height);
    // neighbours in order adjoin in the picture: the variance within a group is about half of their mean squared difference
    const double n = counted.size(), missing = 1.0 - n / blocks.size();
    round.doubt = missing > 0.0 && n > 1.0 ? std::sqrt(missing * differences / (2.0 * (n - 1.0) * n)) : 0.0;
    return round;
}

bool BudgetPilot::Get(const SampleRun& run, SampleResult* results) const
{
    const std::size_t place = run.first.y / Settings::blockSide * columns + run.first.x / Settings::blockSide;
    return records[place] && records[place]->Get(run, results);
}

} // namespace tilt_lens
