#include "models/session/session_model.h"

#include <QMetaObject>

#include <mutex>

namespace carina
{

/// Brings a change from the node's thread to the model's, many changes as one call.
struct SessionModel::Wake {
    std::mutex mutex;
    SessionModel* model = nullptr; ///< null once the model is gone
    bool underway = false;

    void fromNode(const std::shared_ptr<Wake>& self)
    {
        const std::scoped_lock lock{mutex};
        if (!model || underway)
            return;
        underway = true;
        QMetaObject::invokeMethod(
            model, [self] { self->arrived(); }, Qt::QueuedConnection);
    }

    void arrived()
    {
        {
            const std::scoped_lock lock{mutex};
            underway = false;
        }
        if (model) // only this thread takes it away
            Q_EMIT model->changed();
    }
};

SessionModel::SessionModel(SessionNode& node, QObject* parent)
    : QObject{parent}, m_node{node}, m_wake{std::make_shared<Wake>()}
{
    m_wake->model = this;
    m_node.onChange([wake = m_wake] { wake->fromNode(wake); });
}

SessionModel::~SessionModel()
{
    const std::scoped_lock lock{m_wake->mutex};
    m_wake->model = nullptr;
}

QString SessionModel::name() const { return QString::fromStdString(m_node.state()->name()); }

SessionPhase SessionModel::phase() const
{
    const std::optional<SessionTime> now = m_node.now();
    return now ? m_node.state()->phaseAt(*now) : SessionPhase::Prepared;
}

QString SessionModel::textOf(SessionPhase phase)
{
    switch (phase) {
    case SessionPhase::Prepared:
        return tr("Ready to start");
    case SessionPhase::Running:
        return tr("Running");
    case SessionPhase::Paused:
        return tr("Paused");
    case SessionPhase::Ended:
        return tr("Ended");
    }
    return {};
}

QString SessionModel::runningTimeText() const
{
    const std::optional<SessionTime> now = m_node.now();
    return timeText(now ? m_node.state()->runningTime(*now) : Duration{});
}

QString timeText(Duration running)
{
    const auto seconds = std::chrono::floor<std::chrono::seconds>(running).count();
    return QStringLiteral("%1:%2")
        .arg(seconds / 60, 2, 10, QLatin1Char('0'))
        .arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

bool SessionModel::canStart() const
{
    return phase() == SessionPhase::Prepared || phase() == SessionPhase::Paused;
}

bool SessionModel::canPause() const { return phase() == SessionPhase::Running; }

bool SessionModel::canEnd() const { return phase() != SessionPhase::Ended; }

void SessionModel::start() { setPhase(SessionPhase::Running); }
void SessionModel::pause() { setPhase(SessionPhase::Paused); }
void SessionModel::end() { setPhase(SessionPhase::Ended); }

void SessionModel::setPhase(SessionPhase phase)
{
    m_node.propose(kNoStation, fact::PhaseChanged{phase});
}

} // namespace carina
