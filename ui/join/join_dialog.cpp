#include "ui/join/join_dialog.h"

#include "widgets/plain_label.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kListHeight = 110;
constexpr int kDialogWidth = 520;

QLabel* wrapping(const char* name)
{
    auto* label = new PlainLabel;
    label->setObjectName(QLatin1String{name});
    label->setWordWrap(true);
    return label;
}

} // namespace

JoinDialog::JoinDialog(FoundSessionsModel& sessions, Entrance& entrance, const JoinForm& begin,
                       QWidget* parent)
    : QDialog{parent},
      m_sessions{sessions},
      m_entrance{entrance},
      m_list{new QListView},
      m_searching{wrapping("searching")},
      m_address{field("address", tr("Address or link"), begin.address)},
      m_port{field("port", tr("Port"), begin.port)},
      m_code{field("code", tr("Code"), begin.code)},
      m_name{field("name", tr("Your name"), begin.name)},
      m_role{new QComboBox},
      m_station{field("station", tr("Station"), begin.station)},
      m_certificate{field("certificate", tr("Name in its certificate"), begin.certificate)},
      m_form{new QFormLayout},
      m_more{new QPushButton{tr("&More")}},
      m_typed{new QWidget{this}},
      m_missing{wrapping("missing")},
      m_join{new QPushButton{tr("&Join")}},
      m_offered{begin.isPlaceOfLastTime ? begin : JoinForm{}}
{
    setWindowTitle(tr("Join a session"));
    setMinimumWidth(kDialogWidth);
    m_list->setObjectName(QStringLiteral("sessions"));
    m_list->setAccessibleName(tr("Sessions found"));
    m_list->setModel(&sessions);
    m_list->setFixedHeight(kListHeight);
    m_role->setObjectName(QStringLiteral("role"));
    m_role->setAccessibleName(tr("Role"));
    m_role->addItem(tr("Trainee"), QVariant::fromValue(static_cast<int>(Role::Trainee)));
    m_role->addItem(tr("Observer, who watches and changes nothing"),
                    QVariant::fromValue(static_cast<int>(Role::Observer)));
    m_role->setCurrentIndex(m_role->findData(static_cast<int>(begin.role)));
    m_station->setPlaceholderText(tr("empty for the first, or where you were last"));
    m_certificate->setPlaceholderText(tr("empty if the instructor's window names none"));
    m_code->setPlaceholderText(tr("empty if you were in this session before"));
    layOut();
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &JoinDialog::choose);
    connect(&sessions, &QAbstractItemModel::rowsInserted, this, &JoinDialog::tellSearching);
    connect(&sessions, &QAbstractItemModel::rowsRemoved, this, &JoinDialog::tellSearching);
    connect(&sessions, &QAbstractItemModel::rowsInserted, this, &JoinDialog::chooseByItself);
    connect(m_address, &QLineEdit::textChanged, this, &JoinDialog::readLink);
    connect(m_role, &QComboBox::currentIndexChanged, this, &JoinDialog::refresh);
    connect(&m_entrance, &Entrance::changed, this, &JoinDialog::follow);
    readLink();
    tellSearching();
    chooseByItself();
    refresh();
}

JoinForm JoinDialog::form() const
{
    return {m_address->text(),
            m_port->text(),
            m_code->text(),
            m_name->text(),
            static_cast<Role>(m_role->currentData().toInt()),
            m_certificate->text(),
            m_station->text()};
}

QLineEdit* JoinDialog::field(const char* name, const QString& label, const QString& text)
{
    auto* edit = new QLineEdit{text};
    edit->setObjectName(QLatin1String{name});
    edit->setAccessibleName(label);
    connect(edit, &QLineEdit::textChanged, this, &JoinDialog::refresh);
    return edit;
}

void JoinDialog::layOut()
{
    auto* found = new PlainLabel{tr("&Sessions found"), this};
    found->setBuddy(m_list);
    m_typed->setLayout(m_form);
    m_form->setContentsMargins({});
    m_form->addRow(tr("&Address or link"), m_address);
    m_form->addRow(tr("&Port"), m_port);
    m_form->addRow(tr("&Code of your role"), m_code);
    m_form->addRow(tr("Your &name"), m_name);
    m_form->addRow(tr("&Role"), m_role);
    m_form->addRow(tr("St&ation"), m_station);
    m_more->setObjectName(QStringLiteral("more"));
    m_more->setCheckable(true);
    m_more->setAutoDefault(false); // Return joins
    m_more->setToolTip(tr("The name in the certificate of the instructor's computer"));
    connect(m_more, &QPushButton::toggled, this, &JoinDialog::showMore);
    m_form->addRow(m_more);
    m_form->addRow(tr("Cer&tificate"), m_certificate);
    showMore(!m_certificate->text().isEmpty());
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    buttons->addButton(m_join, QDialogButtonBox::AcceptRole);
    m_join->setObjectName(QStringLiteral("join"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout{this};
    column->addWidget(found);
    column->addWidget(m_list);
    column->addWidget(m_searching);
    column->addWidget(m_typed);
    column->addWidget(m_missing);
    column->addWidget(buttons);
    m_join->setDefault(true); // of this dialog, now that it is in it
    QWidget* before = m_list;
    for (QWidget* next : std::initializer_list<QWidget*>{
             m_address, m_port, m_code, m_name, m_role, m_station, m_more, m_certificate, m_join,
             buttons->button(QDialogButtonBox::Cancel)}) {
        setTabOrder(before, next);
        before = next;
    }
}

void JoinDialog::choose(const QModelIndex& session)
{
    if (!session.isValid())
        return;
    const FoundSession& found = m_sessions.at(session.row());
    m_address->setText(QString::fromStdString(found.address));
    m_port->setText(QString::number(found.notice.port));
    if (!m_choosesByItself && m_list->hasFocus())
        m_wasChosen = true;
    else // the list goes on to another row when one is removed
        m_offered = form();
}

/// Whether nobody chose a session, typed where one is, or types the code of the one that is shown.
bool JoinDialog::isLeftToItself() const
{
    const bool isOffered =
        m_address->text() == m_offered.address && m_port->text() == m_offered.port;
    return isOffered && !m_wasChosen && !m_entrance.isTrying()
           && (m_address->text().isEmpty() || m_code->text().isEmpty());
}

void JoinDialog::chooseByItself()
{
    const std::optional<int> known = m_sessions.knownRow();
    if (!isLeftToItself() || (!known && m_sessions.rowCount() != 1))
        return;
    m_choosesByItself = true;
    m_list->setCurrentIndex(m_sessions.index(known.value_or(0)));
    m_choosesByItself = false;
    focusWhatIsMissing(known.has_value());
}

/// Unless somebody types already.
void JoinDialog::focusWhatIsMissing(bool isKnown)
{
    const QWidget* at = focusWidget();
    const bool isTyping =
        at && at != m_list && at != m_join && (at != m_code || !m_code->text().isEmpty());
    if (isTyping)
        return;
    if (isKnown && m_join->isEnabled())
        m_join->setFocus();
    else
        (m_name->text().isEmpty() ? m_name : m_code)->setFocus();
}

void JoinDialog::showMore(bool shown)
{
    m_more->setChecked(shown);
    m_form->setRowVisible(m_certificate, shown);
}

void JoinDialog::readLink()
{
    const JoinForm read = withLinkRead(form());
    if (read.address == m_address->text())
        return;
    m_port->setText(read.port);
    m_code->setText(read.code);
    m_role->setCurrentIndex(m_role->findData(static_cast<int>(read.role)));
    m_certificate->setText(read.certificate);
    showMore(m_more->isChecked() || !read.certificate.isEmpty());
    m_address->setText(read.address);
}

void JoinDialog::accept()
{
    if (!m_entrance.isTrying() && !whatIsMissing(form(), m_entrance.settings().tokens))
        m_entrance.enter(form());
}

void JoinDialog::reject()
{
    if (m_entrance.isTrying())
        m_entrance.stop();
    else
        QDialog::reject();
}

void JoinDialog::follow()
{
    if (m_entrance.isIn()) {
        m_missing->setText(m_entrance.progress());
        m_missing->repaint(); // the patient keeps this program busy from now on
        return QDialog::accept();
    }
    refresh();
    if (const auto& refusal = m_entrance.refusal()) {
        m_missing->setText(refusal->sentence);
        if (refusal->field == JoinField::Certificate)
            showMore(true);
        fieldOf(refusal->field)->setFocus();
        fieldOf(refusal->field)->selectAll();
    }
}

/// What it says has as many lines as it needs: the window grows for them, and nothing is cut.
bool JoinDialog::event(QEvent* event)
{
    const bool isDone = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest && isVisible() && layout() != nullptr) {
        const int wanted = layout()->totalHeightForWidth(width());
        if (height() < wanted)
            resize(width(), wanted);
    }
    return isDone;
}

/// Apart from what is missing or refused, which stays while sessions come and go.
void JoinDialog::tellSearching()
{
    m_searching->setText(m_sessions.rowCount() == 0
                             ? tr("Looking for sessions … If none appears, type the address and "
                                  "port that the instructor's window shows, or paste its link.")
                             : tr("Choose one, type an address and port, or paste a link."));
}

void JoinDialog::refresh()
{
    const bool isTrying = m_entrance.isTrying();
    const auto missing = whatIsMissing(form(), m_entrance.settings().tokens);
    m_missing->setText(isTrying ? m_entrance.progress() : missing ? missing->sentence : QString{});
    if (isTrying && m_typed->isEnabled())
        setFocus(); // a key that is typed on must not press Cancel, which else has the keyboard
    m_typed->setEnabled(!isTrying);
    m_list->setEnabled(!isTrying);
    m_join->setEnabled(!isTrying && !missing);
}

QLineEdit* JoinDialog::fieldOf(JoinField field) const
{
    switch (field) {
    case JoinField::Address:
        return m_address;
    case JoinField::Port:
        return m_port;
    case JoinField::Code:
        return m_code;
    case JoinField::Name:
        return m_name;
    case JoinField::Certificate:
        return m_certificate;
    case JoinField::Station:
        return m_station;
    }
    return nullptr;
}

} // namespace carina
