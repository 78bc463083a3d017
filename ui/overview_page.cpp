#include "ui/overview_page.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace carina
{

OverviewPage::OverviewPage(RegistrationModel& registration)
    : RegistrationPage{registration}, m_health{new QLabel{this}}, m_operator{new QLineEdit{this}}
{
    m_health->setWordWrap(true);
    m_health->setObjectName(QStringLiteral("health"));
    m_health->setAccessibleName(tr("State of the site"));
    m_operator->setObjectName(QStringLiteral("operator"));
    m_operator->setAccessibleName(tr("Your name, kept with what you do"));
    m_operator->setMaxLength(80);
    connect(m_operator, &QLineEdit::editingFinished, this,
            [this] { this->registration().setOperator(m_operator->text()); });

    auto* save = new QPushButton{tr("&Export the site…"), this};
    connect(save, &QPushButton::clicked, this, &OverviewPage::chooseExport);
    auto* load = new QPushButton{tr("&Import a site…"), this};
    connect(load, &QPushButton::clicked, this, &OverviewPage::chooseImport);
    auto* report = new QPushButton{tr("&Report as PDF…"), this};
    report->setObjectName(QStringLiteral("report"));
    connect(report, &QPushButton::clicked, this, &OverviewPage::reportWanted);

    auto* moved = new QPushButton{tr("The manikin was &moved…"), this};
    moved->setObjectName(QStringLiteral("moved"));
    moved->setToolTip(tr("Lay it anew by touching three of its landmarks"));
    connect(moved, &QPushButton::clicked, this,
            [this] { this->registration().touching().beginRelay(); });

    auto* form = new QFormLayout;
    form->addRow(tr("&Your name"), m_operator);
    auto* files = new QHBoxLayout;
    for (QPushButton* button : {save, load, report})
        files->addWidget(button);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_health);
    column->addLayout(form);
    column->addWidget(moved);
    column->addLayout(files);
    column->addStretch();
}

void OverviewPage::refresh()
{
    m_health->setText(registration().health().join(QStringLiteral("\n\n")));
    if (!m_operator->hasFocus())
        m_operator->setText(QString::fromStdString(registration().site().operatorName));
    for (const char* button : {"report", "moved"})
        findChild<QPushButton*>(QLatin1StringView{button})
            ->setEnabled(registration().site().registration.has_value());
}

QString OverviewPage::actionText() const
{
    const SiteStep next = registration().nextStep();
    return next == SiteStep::Overview ? tr("&Finish") : tr("&Go on: %1").arg(stepTitle(next));
}

void OverviewPage::act()
{
    const SiteStep next = registration().nextStep();
    if (next == SiteStep::Overview)
        Q_EMIT finished();
    else
        registration().enter(next);
}

void OverviewPage::chooseExport()
{
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Export the site"), QStringLiteral("site.json"), tr("Carina site (*.json)"));
    if (!file.isEmpty())
        registration().exportSite(file);
}

void OverviewPage::chooseImport()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Import a site"), {}, tr("Carina site (*.json)"));
    if (!file.isEmpty())
        registration().importSite(file);
}

} // namespace carina
