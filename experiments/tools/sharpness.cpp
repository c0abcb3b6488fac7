// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "sharpness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace paper
{

namespace
{

struct Disc
{
    int reach = 0;
    std::vector<double> weights;  ///< (2 reach + 1) squared

    explicit Disc(double diameter)
    {
        const double radius = 0.5 * diameter;
        reach = static_cast<int>(std::ceil(radius + 0.5));
        const int fine = 8;
        double sum = 0.0;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
            {
                // fine cells on the rim count in part: no steps
                double inside = 0.0;
                for (int k = 0; k < fine * fine; ++k)
                {
                    const double distance = std::hypot(x + (k % fine + 0.5) / fine - 0.5, y + (k / fine + 0.5) / fine - 0.5);
                    inside += std::clamp(fine * (radius - distance) + 0.5, 0.0, 1.0);
                }
                weights.push_back(inside);
                sum += inside;
            }
        if (sum == 0.0)  // smaller than a fine cell: the pixel itself
            sum = weights[weights.size() / 2] = 1.0;
        for (double& weight : weights)
            weight /= sum;
    }

    /// From the weights' variance: the grid widens them, and a disc within one pixel has no effect.
    double TrueDiameter() const
    {
        double variance = 0.0;
        const double* weight = weights.data();
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                variance += 0.5 * (x * x + y * y) * *weight++;
        return 4.0 * std::sqrt(variance);
    }
};

/// n times finer, each spread over n by n cells.
Disc Spread(const Disc& disc, int n)
{
    Disc wide(0.0);
    wide.reach = disc.reach + n / 2;
    const int from = 2 * disc.reach + 1, to = 2 * wide.reach + 1;
    wide.weights.assign(static_cast<std::size_t>(to) * to, 0.0);
    for (int y = 0; y < from; ++y)
        for (int x = 0; x < from; ++x)
            for (int k = 0; k < n * n; ++k)
                wide.weights[(y + k / n) * to + x + k % n] += disc.weights[y * from + x] / (n * n);
    return wide;
}

class Match
{
  public:
    Match(const witness::Picture& sharp, const witness::Picture& blurred, const Window& window) :
        mWidth(sharp.width), mHeight(sharp.height), mFiner(sharp.width / blurred.width), mWindow(window)
    {
        for (int row = 0; row < mHeight; ++row)
            for (int column = 0; column < mWidth; ++column)
                mSharp.push_back(Luminance(sharp, column, row));
        // some thousand pixels of a large window
        mStep = std::max(1, static_cast<int>(std::sqrt(window.width * window.height / 1500.0)));
        double sum = 0.0, squares = 0.0;
        for (int row = 0; row < window.height; row += mStep)
            for (int column = 0; column < window.width; column += mStep)
            {
                mWanted.push_back(Luminance(blurred, window.left + column, window.top + row));
                const double light = At(Fine(window.left + column), Fine(window.top + row));
                sum += light;
                squares += light * light;
            }
        const double count = static_cast<double>(mWanted.size());
        mContrast = std::sqrt(std::max(0.0, squares / count - sum * sum / count / count));
    }

    double Contrast() const { return mContrast; }
    double TrueDiameter(double diameter) const { return Disc(mFiner * diameter).TrueDiameter() / mFiner; }

    double Error(double diameter) const
    {
        const Disc disc = Spread(Disc(mFiner * diameter), mFiner);
        double squares = 0.0;
        std::size_t next = 0;
        for (int row = 0; row < mWindow.height; row += mStep)
            for (int column = 0; column < mWindow.width; column += mStep)
            {
                const double* weight = disc.weights.data();
                double sum = 0.0;
                for (int y = -disc.reach; y <= disc.reach; ++y)
                    for (int x = -disc.reach; x <= disc.reach; ++x)
                        sum += *weight++ * At(Fine(mWindow.left + column) + x, Fine(mWindow.top + row) + y);
                const double off = sum - mWanted[next++];
                squares += off * off;
            }
        return std::sqrt(squares / static_cast<double>(mWanted.size()));
    }

  private:
    int Fine(int pixel) const { return mFiner * pixel + mFiner / 2; }

    double At(int column, int row) const
    {
        return mSharp[static_cast<std::size_t>(std::clamp(row, 0, mHeight - 1)) * mWidth + std::clamp(column, 0, mWidth - 1)];
    }

    int mWidth, mHeight, mFiner, mStep = 1;
    Window mWindow;
    std::vector<double> mSharp, mWanted;
    double mContrast = 0.0;
};

} // namespace

Blur BlurBetween(const witness::Picture& sharp, const witness::Picture& blurred, const Window& window, double widest)
{
    const int finer = blurred.width > 0 ? sharp.width / blurred.width : 0;
    if (finer % 2 == 0 || sharp.width != finer * blurred.width || sharp.height != finer * blurred.height)
        throw std::invalid_argument("the sharp picture must be 1, 3, 5 ... times as wide and high");
    if (window.left < 0 || window.top < 0 || window.width < 2 || window.height < 2 || window.left + window.width > blurred.width ||
        window.top + window.height > blurred.height)
        throw std::invalid_argument("the window leaves the picture");
    const Match match(sharp, blurred, window);
    if (!(match.Contrast() > 0.0))
        throw std::invalid_argument("the window has no contrast");
    // growing steps find the valley, bisection its bottom
    double best = 0.0, least = match.Error(0.0), low = 0.0, high = 0.5;
    for (double last = 0.0, here = 0.5; last < widest; last = here, here = 1.12 * here + 0.2)
        if (const double error = match.Error(here); error < least)
        {
            best = here;
            least = error;
            low = last;
            high = std::min(1.12 * here + 0.2, widest);
        }
    while (high - low > 0.01)
    {
        const double third = (high - low) / 3.0;
        const double left = match.Error(low + third), right = match.Error(high - third);
        (left < right ? high : low) = left < right ? high - third : low + third;
        best = 0.5 * (low + high);
        least = std::min(left, right);
    }
    return {match.TrueDiameter(best), least / match.Contrast()};
}

double MeanSteepness(const witness::Picture& picture, Point from, Point to, double reach)
{
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0.0))
        throw std::invalid_argument("a line of no length");
    const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
    double sum = 0.0;
    int count = 0;
    for (int row = 1; row < picture.height - 1; ++row)
        for (int column = 1; column < picture.width - 1; ++column)
        {
            const double x = column + 0.5 - from.x, y = row + 0.5 - from.y;
            const double along = x * dx + y * dy, across = x * dy - y * dx;
            if (along < 0.0 || along > length || std::fabs(across) > reach)
                continue;
            const auto level = [&](int i, int j) { return Level(Luminance(picture, column + i, row + j)); };
            sum += 0.5 * std::hypot(level(1, 0) - level(-1, 0), level(0, 1) - level(0, -1));
            ++count;
        }
    if (count == 0)
        throw std::invalid_argument("the line leaves the picture");
    return sum / count;
}

} // namespace paper
