#include "models/airway/gradual_decision.h"

#include <QTimer>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kGradualLook_ms = 50;

} // namespace

GradualDecision::GradualDecision(SessionModel& session, QObject* parent)
    : QObject{parent}, m_session{session}
{
    connect(&m_session, &SessionModel::changed, this, &GradualDecision::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &GradualDecision::refresh);
    timer->start(kGradualLook_ms);
}

} // namespace carina
