#include "ui/tracker/program_tracker_panel.h"

#include "ui/tracker/offer_box.h"
#include "ui/tracker/record_button.h"
#include "widgets/plain_label.h"

#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace carina
{

ProgramTrackerPanel::ProgramTrackerPanel(const ProgramTracker& tracker, QWidget* parent)
    : QWidget{parent}
{
    auto* column = new QVBoxLayout{this};
    if (tracker.canBeGiven)
        offerAnother(*column, tracker);
    m_tools = new TrackerPanel{tracker.sight, tracker.sound};
    if (tracker.treatment.choose)
        m_tools->offer(tracker.treatment);
    column->addWidget(m_tools, 1);
    if (!focusProxy())
        setFocusProxy(m_tools);
    if (tracker.recording)
        column->addWidget(new RecordButton{*tracker.recording});
    if (tracker.offer)
        column->addWidget(new OfferBox{*tracker.offer});
}

void ProgramTrackerPanel::offerAnother(QVBoxLayout& column, const ProgramTracker& tracker)
{
    auto* invitation = new PlainLabel{
        tr("Connect one to work with tools of your own, which everybody at the station sees.")};
    invitation->setObjectName(QStringLiteral("trackerInvitation"));
    invitation->setWordWrap(true);
    auto* give = new QPushButton{tr("Connec&t a tracker…")};
    give->setObjectName(QStringLiteral("connectTracker"));
    auto* take = new QPushButton{tr("Go on w&ithout the tracker")};
    take->setObjectName(QStringLiteral("withoutTracker"));
    // Queued: a dialog opens, and whoever pressed the button is not to wait for its end.
    connect(give, &QPushButton::clicked, this, &ProgramTrackerPanel::wanted, Qt::QueuedConnection);
    connect(take, &QPushButton::clicked, this, &ProgramTrackerPanel::unwanted);
    column.addWidget(invitation);
    column.addWidget(give);
    setFocusProxy(give); // the first by the keyboard, too
    column.addWidget(take);
    auto* timer = new QTimer{this};
    const auto refresh = [invitation, take, sight = tracker.sight] {
        const bool isThere = sight && sight();
        invitation->setVisible(!isThere);
        take->setEnabled(isThere);
    };
    connect(timer, &QTimer::timeout, this, refresh);
    timer->start(TrackerPanel::kInterval_ms);
    refresh();
}

} // namespace carina
