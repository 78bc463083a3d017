#include "widgets/scene/look/picture_quality.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <utility>

namespace carina
{

const char* qualityName(PictureQuality quality)
{
    switch (quality) {
    case PictureQuality::Quick:
        return "quick";
    case PictureQuality::Smoothed:
        return "smoothed";
    case PictureQuality::Fine:
        return "fine";
    }
    return "";
}

QualityChoice::QualityChoice(Duration budgetPerFrame) : m_budget{budgetPerFrame}
{
    CARINA_EXPECTS(budgetPerFrame > Duration::zero());
}

void QualityChoice::fix(std::optional<PictureQuality> quality)
{
    m_fixed = quality;
    startCounting();
}

void QualityChoice::beginAnew()
{
    m_quality = PictureQuality::Quick;
    m_quick.fill(Duration::max());
    m_isTried = false;
    m_decisionsLeft = 0;
    m_toSettle = kFramesToSettle;
    startCounting();
}

void QualityChoice::startCounting()
{
    m_frames = 0;
    m_sum = Duration::zero();
}

void QualityChoice::frameTook(Duration drawing, Duration interval, bool isDetailFinest)
{
    if (m_fixed)
        return;
    if (m_toSettle > 0) {
        --m_toSettle;
        return;
    }
    m_sum += drawing;
    if (++m_frames < kFramesPerDecision && m_sum < kFramesPerDecision * m_budget)
        return;
    decide(m_sum / m_frames, interval, isDetailFinest);
    startCounting();
}

void QualityChoice::decide(Duration mean, Duration interval, bool isDetailFinest)
{
    if (m_quality == PictureQuality::Quick)
        m_quick = {m_quick.back(), mean};
    const bool isTrial = std::exchange(m_isTried, false);
    if (mean > m_budget || (isTrial && addsTooMuch(mean, interval)))
        fall();
    else if (m_decisionsLeft > 0)
        --m_decisionsLeft;
    else if (isDetailFinest && toSeconds(mean) < kComfort * toSeconds(m_budget))
        tryNext();
}

bool QualityChoice::addsTooMuch(Duration mean, Duration interval) const
{
    const Duration quick = std::min(m_quick.front(), m_quick.back());
    return toSeconds(mean - quick) > kMostAdded * toSeconds(std::max(quick, interval));
}

void QualityChoice::fall()
{
    if (m_quality == PictureQuality::Quick)
        return;
    m_decisionsLeft = kDecisionsApart;
    change(-1);
}

void QualityChoice::tryNext()
{
    if (m_quality == PictureQuality::Fine || m_quick.front() == Duration::max())
        return;
    m_isTried = true;
    change(1);
}

void QualityChoice::change(int steps)
{
    m_quality = static_cast<PictureQuality>(static_cast<int>(m_quality) + steps);
    m_toSettle = kFramesToSettle;
}

} // namespace carina
