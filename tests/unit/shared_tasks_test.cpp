// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/shared_tasks.h"

#include <atomic>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "together.h"

namespace tilt_lens
{
namespace
{

void RunTasks(SharedTasks& tasks, int threads, const std::function<void(std::size_t)>& work, const std::function<void()>& endRound)
{
    TakeTogether(threads, [&] { return tasks.Next(); }, [&](std::size_t task) { tasks.Take(task, [&] { work(task); }, endRound); });
}

TEST(SharedTasks, TakeEachTaskOfEachRoundOnce)
{
    constexpr std::size_t rounds = 20, count = 30;
    SharedTasks tasks;
    std::vector<std::atomic<int>> taken(rounds * count);
    std::atomic<std::size_t> round{0}, tried{0};
    tasks.BeginRound(count);
    const auto work = [&](std::size_t task)
    {
        if (++tried % 7 == 3)
            throw std::runtime_error("interrupted");
        taken[round * count + task]++;
    };
    RunTasks(tasks, 4, work, [&] { tasks.BeginRound(++round < rounds ? count : 0); });
    for (const std::atomic<int>& one : taken)
        EXPECT_EQ(one, 1);
    EXPECT_FALSE(tasks.Next());
}

TEST(SharedTasks, EndForAllWhenARoundCannotEnd)
{
    SharedTasks tasks;
    tasks.BeginRound(50);
    std::atomic<int> ended{0};
    RunTasks(tasks, 4, [](std::size_t) {}, [&]
    {
        ended++;
        throw std::runtime_error("no memory");
    });
    EXPECT_EQ(ended, 1);
    EXPECT_FALSE(tasks.Next());
}

TEST(SharedTasks, TellTheRoundAndItsShare)
{
    SharedTasks tasks;
    std::vector<std::size_t> later{4, 0};
    const auto expect = [&tasks](std::size_t round, double share)
    {
        EXPECT_EQ(tasks.Progress().round, round);
        EXPECT_EQ(tasks.Progress().share, share);
    };
    const auto take = [&]
    {
        tasks.Take(*tasks.Next(), [] {}, [&]
        {
            tasks.BeginRound(later.front());
            later.erase(later.begin());
        });
    };
    tasks.BeginRound(2);
    expect(1, 0.0);
    take();
    expect(1, 0.5);
    take();
    expect(2, 0.0);
    take();
    expect(2, 0.25);
    for (int i = 0; i < 3; i++)
        take();
    expect(2, 1.0);
}

} // namespace
} // namespace tilt_lens
