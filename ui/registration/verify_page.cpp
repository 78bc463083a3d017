#include "ui/registration/verify_page.h"

#include "models/text/shown_as_is.h"
#include "ui/registration/error_table.h"
#include "widgets/plain_label.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kLongestName = 80;

enum CheckColumn { PlaceColumn, ErrorColumn, BoundColumn, WithinColumn, CheckColumnCount };

} // namespace

VerifyPage::VerifyPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_points{new QTableWidget{0, CheckColumnCount, this}},
      m_verdict{new PlainLabel{this}},
      m_nameWanted{new PlainLabel{
          tr("▲ Your na&me is asked for: it stands beside the verdict, in the report, too."),
          this}},
      m_name{new QLineEdit{this}},
      m_stylus{new PlainLabel{this}},
      m_take{new QPushButton{tr("&Take this point"), this}}
{
    m_points->setObjectName(QStringLiteral("checks"));
    m_points->setAccessibleName(tr("Places to check"));
    m_points->setHorizontalHeaderLabels({tr("Place"), tr("Error"), tr("95 % below"), tr("Within")});
    makeReadable(*m_points);
    m_verdict->setWordWrap(true);
    m_verdict->setObjectName(QStringLiteral("verdict"));
    m_nameWanted->setWordWrap(true);
    m_nameWanted->setBuddy(m_name);
    m_name->setObjectName(QStringLiteral("judge"));
    m_name->setAccessibleName(tr("Your name, recorded with the verdict"));
    m_name->setPlaceholderText(tr("Your name"));
    m_name->setMaxLength(kLongestName);
    connect(m_name, &QLineEdit::editingFinished, this,
            [this] { this->registration().setOperator(m_name->text()); });
    connect(m_name, &QLineEdit::textChanged, this, &VerifyPage::refreshName);
    m_stylus->setWordWrap(true);
    m_stylus->setObjectName(QStringLiteral("stylus"));
    m_stylus->setAccessibleName(tr("Where the stylus is on the anatomy"));
    connect(m_take, &QPushButton::clicked, &registration, &RegistrationModel::takeNow);
    const auto choose = [this](int row) {
        if (row >= 0)
            this->registration().verifying().choose(std::size_t(row));
    };
    connect(m_points, &QTableWidget::cellClicked, this, choose);
    auto* space = new QShortcut{Qt::Key_Space, m_points};
    space->setContext(Qt::WidgetShortcut);
    connect(space, &QShortcut::activated, this, [this, choose] { choose(m_points->currentRow()); });
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    for (QWidget* widget : std::initializer_list<QWidget*>{m_points, m_take, m_verdict,
                                                           m_nameWanted, m_name, m_stylus})
        column->addWidget(widget);
    column->addStretch();
}

void VerifyPage::refresh()
{
    fillPoints();
    m_take->setEnabled(registration().verifying().next().has_value());
    m_verdict->setText(verdict());
    refreshName();
    refreshLive();
}

/// The name is asked for until one is there, also one that is still being typed.
void VerifyPage::refreshName()
{
    const bool isNamed = !registration().site().operatorName.empty();
    m_nameWanted->setVisible(!isNamed && m_name->text().trimmed().isEmpty());
    m_name->setVisible(!isNamed || m_name->hasFocus());
}

void VerifyPage::fillPoints()
{
    const std::vector<CheckPoint> points = registration().verifying().points();
    const auto next = registration().verifying().next();
    m_points->setRowCount(int(points.size()));
    for (int row = 0; row < m_points->rowCount(); ++row) {
        const CheckPoint& point = points[std::size_t(row)];
        const bool isNext = next == std::size_t(row);
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem{text};
            QFont font = item->font();
            font.setBold(isNext);
            item->setFont(font);
            item->setToolTip(shownAsIs(text)); // a long name may not fit
            m_points->setItem(row, column, item);
        };
        put(PlaceColumn, point.name);
        put(ErrorColumn, point.error_mm ? tr("%1 mm").arg(*point.error_mm, 0, 'f', 1)
                                        : (isNext ? tr("● now") : tr("○ open")));
        put(BoundColumn, tr("%1 mm").arg(point.bound_mm, 0, 'f', 1));
        put(WithinColumn, !point.error_mm       ? QString{}
                          : point.isWithin()    ? tr("✓ yes")
                          : point.isTolerated() ? tr("▲ limit %1 mm").arg(point.limit_mm, 0, 'f', 1)
                                                : tr("▲ no"));
    }
    fitHeight(*m_points);
}

/// And that it says nothing of the airway, where it does not.
QString VerifyPage::verdict() const
{
    const VerifyTask& task = registration().verifying();
    QStringList told{verdictOfErrors(), tolerated(), rule()};
    told.removeAll(QString{});
    const QString sentence = told.join(QLatin1Char('\n'));
    if (task.suggestion() != Verdict::Good || task.hasAirwayPoint())
        return sentence;
    return sentence + QLatin1Char('\n')
           + tr("▲ None of these places lies at the height of the airway: touch the edge of the "
                "upper incisors, or the front of the larynx.");
}

/// Which places the table has beyond their own bound, beside a verdict that is good.
QString VerifyPage::tolerated() const
{
    if (registration().verifying().suggestion() != Verdict::Good)
        return {};
    QStringList names;
    for (const CheckPoint& point : registration().verifying().points())
        if (point.isTolerated())
            names += point.name;
    return names.isEmpty()
               ? QString{}
               : tr("▲ Beyond its own 95 % bound, and within the limit that counts: %1.",
                    "names of places")
                     .arg(names.join(QStringLiteral(", ")));
}

QString VerifyPage::rule() const
{
    const VerifyTask& task = registration().verifying();
    return task.suggestion() == Verdict::Open
               ? QString{}
               : tr("Rule: good if no error exceeds the limit of its place. The limits are larger "
                    "than the 95 % bounds, such that all %1 places together keep them in 95 of 100 "
                    "registrations; one place in twenty is beyond its own bound by chance.")
                     .arg(task.touched());
}

QString VerifyPage::verdictOfErrors() const
{
    if (isNotGood(registration().site()))
        return tr("▲ Recorded as not good: touch the landmarks again.");
    if (registration().verifying().isRecorded())
        return tolerated().isEmpty()
                   ? tr("✓ Verified: the errors are as small as expected.")
                   : tr("✓ Verified: taken together the errors are as small as expected, although "
                        "some single errors are larger.");
    if (registration().site().registration && !registration().verifying().canJudge())
        return tr("▲ This registration is of an older version, which did not keep how large its "
                  "error may be: fit the landmarks again.");
    switch (registration().verifying().suggestion()) {
    case Verdict::Open:
        return tr("Touch these places. %1 are the fewest that can be judged by.")
            .arg(VerifyTask::kFewestPoints);
    case Verdict::Good:
        return registration().verifying().isComplete()
                   ? tr("✓ The errors are as small as expected.")
                   : tr(
                       "✓ So far the errors are as small as expected. Touch the other places, too, "
                       "or record it where they cannot be touched.");
    case Verdict::NotGood:
        return tr("▲ An error is larger than expected: look at the fit, or touch the landmarks "
                  "again.");
    }
    return {};
}

void VerifyPage::refreshLive()
{
    m_stylus->setVisible(registration().site().registration.has_value());
    const auto stylus = registration().stylusOnAnatomy();
    m_stylus->setText(stylus ? tr("The tip is %1 mm from %2 and %3 mm from the surface of %4.")
                                   .arg(stylus->landmark_mm, 0, 'f', 1)
                                   .arg(stylus->nearestLandmark)
                                   .arg(stylus->surface_mm, 0, 'f', 1)
                                   .arg(stylus->nearestSurface)
                             : tr("▲ The stylus is out of view."));
}

QString VerifyPage::actionText() const
{
    if (isNotGood(registration().site()))
        return tr("Touch &again");
    return registration().verifying().suggestion() == Verdict::NotGood
               ? tr("&Record: not good enough")
               : tr("&Record: good");
}

bool VerifyPage::canAct() const
{
    const VerifyTask& task = registration().verifying();
    return isNotGood(registration().site())
           || (task.suggestion() != Verdict::Open && !task.isRecorded());
}

bool VerifyPage::isReady() const
{
    return registration().task(SiteStep::Verify).state == TaskState::Done
           || isNotGood(registration().site())
           || (canAct() && registration().verifying().isComplete()
               && registration().verifying().hasAirwayPoint());
}

void VerifyPage::act()
{
    if (isNotGood(registration().site()))
        return registration().enter(SiteStep::Touch);
    registration().verifying().record(registration().verifying().suggestion());
}

} // namespace carina
