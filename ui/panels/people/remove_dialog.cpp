#include "ui/panels/people/remove_dialog.h"

#include "models/session/conduct_model.h"
#include "widgets/dialog_buttons.h"
#include "widgets/plain_label.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace carina
{
namespace
{

constexpr int kRemoveDialogWidth = 420;

} // namespace

RemoveDialog::RemoveDialog(const QString& name, QWidget* parent)
    : QDialog{parent},
      m_reason{new QLineEdit},
      m_forGood{new QCheckBox{tr("&Do not let them back in")}},
      m_missing{new PlainLabel},
      m_remove{new QPushButton{tr("&Remove")}}
{
    setWindowTitle(tr("Remove a participant"));
    setMinimumWidth(kRemoveDialogWidth);
    auto* question = new PlainLabel{tr("Remove %1 from the session?").arg(name)};
    question->setWordWrap(true);
    m_reason->setObjectName(QStringLiteral("reason"));
    m_reason->setAccessibleName(tr("Reason"));
    m_reason->setPlaceholderText(tr("is shown to the participant"));
    m_forGood->setObjectName(QStringLiteral("forGood"));
    m_forGood->setToolTip(tr("Their name and token are refused from now on. Who has the code of "
                             "the role can join under another name: give the role a new code."));
    m_missing->setObjectName(QStringLiteral("missing"));
    m_missing->setWordWrap(true);
    m_remove->setObjectName(QStringLiteral("remove"));
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    buttons->addButton(m_remove, QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_reason, &QLineEdit::textChanged, this, &RemoveDialog::refresh);
    auto* rows = new QFormLayout{this};
    rows->addRow(question);
    rows->addRow(tr("R&eason"), m_reason);
    rows->addRow(m_forGood);
    rows->addRow(m_missing);
    rows->addRow(buttons);
    leadTabToCancel(*buttons, *m_remove);
    buttons->button(QDialogButtonBox::Cancel)->setDefault(true); // removing is never by mistake
    refresh();
}

QString RemoveDialog::reason() const { return m_reason->text().trimmed(); }

bool RemoveDialog::isForGood() const { return m_forGood->isChecked(); }

void RemoveDialog::refresh()
{
    const bool fits = ConductModel::isShortEnough(reason());
    m_missing->setText(fits ? QString{} : tr("Type a shorter reason."));
    m_missing->setVisible(!fits);
    m_remove->setEnabled(fits);
}

} // namespace carina
