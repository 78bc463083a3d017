#include "widgets/spoken_label.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QVariant>

namespace carina
{
namespace
{

constexpr const char* kSpokenInstead = "spokenInstead";

/// As it is shown: a label of a field marks the key of the field by &, and shows && as &.
QString shownText(const QLabel& label)
{
    QString text = label.text();
    if (!label.buddy())
        return text;
    for (qsizetype place = text.indexOf(QLatin1Char{'&'}); place >= 0;
         place = text.indexOf(QLatin1Char{'&'}, place + 1))
        text.remove(place, 1);
    return text;
}

class SpokenLabel : public QAccessibleWidget
{
public:
    explicit SpokenLabel(QLabel* label) : QAccessibleWidget{label, QAccessible::StaticText} {}

    [[nodiscard]] QString text(QAccessible::Text which) const override
    {
        if (which != QAccessible::Name)
            return QAccessibleWidget::text(which);
        const auto& label = static_cast<const QLabel&>(*widget());
        const QString name = label.accessibleName();
        if (label.text().isEmpty() || label.property(kSpokenInstead).toBool())
            return name;
        if (name.isEmpty())
            return shownText(label);
        return QCoreApplication::translate("SpokenLabel", "%1: %2", "what it is about; its text")
            .arg(name, shownText(label));
    }

    [[nodiscard]] QList<std::pair<QAccessibleInterface*, QAccessible::Relation>>
    relations(QAccessible::Relation which) const override
    {
        auto all = QAccessibleWidget::relations(which);
        QWidget* buddy = static_cast<const QLabel&>(*widget()).buddy();
        if (buddy && which.testFlag(QAccessible::Labelled))
            all.append({QAccessible::queryAccessibleInterface(buddy), QAccessible::Labelled});
        return all;
    }
};

/// For each label, because one may get its name after it was first spoken of.
QAccessibleInterface* spokenLabel(const QString&, QObject* object)
{
    auto* label = qobject_cast<QLabel*>(object);
    return label ? new SpokenLabel{label} : nullptr;
}

} // namespace

void installSpokenLabels() { QAccessible::installFactory(spokenLabel); }

void speakInstead(QLabel& label, const QString& words)
{
    label.setProperty(kSpokenInstead, true);
    label.setAccessibleName(words);
}

} // namespace carina
