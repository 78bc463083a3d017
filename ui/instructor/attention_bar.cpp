#include "ui/instructor/attention_bar.h"

#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"
#include "widgets/spoken_label.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kAttentionMargin = 8; ///< pixels, as beside the stations above
constexpr int kTextSpare = 4;       ///< pixels, so that rounding wraps no line

/// What a choice does and to what, in which & is no mark of a key.
QString entryOf(const QString& action, const Attention& attention)
{
    QString text = AttentionBar::tr("%1: %2", "what a choice does; what is the matter")
                       .arg(action, attention.text);
    return text.replace(QLatin1Char{'&'}, QStringLiteral("&&"));
}

QStringList actionWords()
{
    return {AttentionModel::tr("Give"),    AttentionModel::tr("Show"),
            AttentionModel::tr("Dismiss"), AttentionModel::tr("Try again"),
            AttentionModel::tr("Connect"), AttentionModel::tr("Show again")};
}

} // namespace

AttentionBar::AttentionBar(QWidget* parent)
    : QWidget{parent},
      m_action{new QPushButton},
      m_dismiss{new QPushButton{AttentionModel::tr("Dismiss")}},
      m_text{new PlainLabel},
      m_more{new QToolButton}
{
    setAccessibleName(tr("What needs attention"));
    m_action->setObjectName(QStringLiteral("attend"));
    m_action->setFocusPolicy(Qt::TabFocus); // who clicks it does not hold it
    m_dismiss->setObjectName(QStringLiteral("dismissAttention"));
    m_dismiss->setFocusPolicy(Qt::TabFocus);
    m_dismiss->setToolTip(tr("It is not told any more; nothing else changes"));
    m_text->setObjectName(QStringLiteral("attention"));
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_text->setWordWrap(true);
    m_more->setObjectName(QStringLiteral("moreAttention"));
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setFocusPolicy(Qt::StrongFocus);
    m_more->setMenu(&m_others);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(kAttentionMargin, 1, kAttentionMargin, 1);
    row->addWidget(m_action);
    row->addWidget(m_dismiss);
    row->addWidget(m_text, 1);
    row->addWidget(m_more);
    connect(m_action, &QPushButton::clicked, this, [this] { m_model->act(Attention{m_shown}); });
    connect(m_dismiss, &QPushButton::clicked, this,
            [this] { m_model->dismiss(Attention{m_shown}); });
    connect(&m_others, &QMenu::aboutToShow, this, &AttentionBar::listOthers);
}

void AttentionBar::setModel(AttentionModel& model)
{
    m_model = &model;
    m_action->ensurePolished();
    int widest = 0;
    for (const QString& word : actionWords()) {
        m_action->setText(word);
        widest = std::max(widest, m_action->sizeHint().width());
    }
    m_action->setFixedWidth(widest);
    connect(&model, &AttentionModel::changed, this, &AttentionBar::refresh);
    refresh();
}

/// What is shown already, where somebody is about to press its button and it is not settled.
Attention AttentionBar::first() const
{
    const auto& all = m_model->all();
    if (all.empty())
        return {};
    const auto same = std::ranges::find_if(
        all, [this](const Attention& each) { return isSameMatter(each, m_shown); });
    const bool isHeld = m_action->underMouse() || m_action->hasFocus() || m_dismiss->underMouse()
                        || m_dismiss->hasFocus();
    return isHeld && same != all.end() ? *same : all.front();
}

void AttentionBar::refresh()
{
    const auto& all = m_model->all();
    const Attention before = std::exchange(m_shown, first());
    m_more->setVisible(all.size() > 1);
    m_action->setText(m_shown.action);
    m_action->setAccessibleDescription(m_shown.text);
    m_dismiss->setVisible(m_shown.canBeDismissed);
    m_dismiss->setAccessibleDescription(m_shown.text);
    m_more->setText(tr("and %n more", nullptr, int(all.size()) - 1));
    showText();
    setVisible(!all.empty());
    if (!all.empty() && (before.text.isEmpty() || !isSameMatter(before, m_shown)))
        announce(m_shown.text);
}

void AttentionBar::showText()
{
    m_text->setText(tr("▲ %1", "what needs attention").arg(m_shown.text));
    m_text->setToolTip(shownAsIs(m_shown.text));
    speakInstead(*m_text, m_shown.text);
}

void AttentionBar::announce(const QString& text)
{
    m_text->setAccessibleDescription(text);
    QAccessibleEvent event{m_text, QAccessible::Alert};
    QAccessible::updateAccessibility(&event);
}

void AttentionBar::listOther(const Attention& other)
{
    m_others.addAction(entryOf(other.action, other), this, [this, other] { m_model->act(other); });
    if (other.canBeDismissed)
        m_others.addAction(entryOf(m_dismiss->text(), other), this,
                           [this, other] { m_model->dismiss(other); });
}

void AttentionBar::listOthers()
{
    m_others.clear();
    for (const Attention& each : m_model->all())
        if (!isSameMatter(each, m_shown))
            listOther(each);
}

void AttentionBar::lie(const QRect& place)
{
    setGeometry(place);
    layout()->invalidate(); // it was laid out for what it said before it was hidden
    layout()->activate();
}

/// Its text wraps in what the buttons leave of the width.
QSize AttentionBar::sizeIn(int width) const
{
    const int inOneLine = m_text->fontMetrics().horizontalAdvance(m_text->text()) + kTextSpare;
    const int taken = std::min(width, layout()->totalSizeHint().width() + inOneLine);
    return {taken, layout()->totalHeightForWidth(taken)};
}

} // namespace carina
