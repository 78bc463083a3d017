#pragma once

#include "models/session/change_history.h"
#include "widgets/scene/look/part_look.h"

#include <QPointer>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace carina
{

class SceneView;

/// Which parts of the patient a view shows, and how: solid, ghost, hidden, highlighted, labelled,
/// in a plain colour. The parts are a tree by region of the body. A check box shows or hides a
/// part, that of a region all its parts that are listed. The buttons apply to the parts selected in
/// the list, by mouse or keyboard, a region standing for its listed parts; the text field above
/// filters the list.
class PartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PartsPanel(QWidget* parent = nullptr);

    /// Lists the parts that the view has now. @pre the view outlives the panel.
    void setScene(SceneView& scene);
    /// Adds its changes to a history from now on.
    void setHistory(ChangeHistory& history) { m_history = &history; }
    /// Chooses a part in the list, and no other; std::nullopt chooses none. A filter that hides it
    /// is cleared.
    void choose(std::optional<std::uint16_t> part);
    /// Shows the parts so, as one change.
    void put(const PartLooks& looks);

Q_SIGNALS:
    /// A person chose these parts in the list; a region stands for its listed parts.
    void chosenInList(const std::vector<std::uint16_t>& parts);

private:
    void layOut();
    [[nodiscard]] QPushButton* styleButton(const QString& text, const QString& toolTip,
                                           PartStyle style);
    /// A button and the member of PartLook that it toggles.
    struct Switch {
        QPushButton* button;
        bool PartLook::*which;
    };
    [[nodiscard]] Switch switchFor(const QString& text, const QString& toolTip,
                                   bool PartLook::*which);
    [[nodiscard]] std::vector<QTreeWidgetItem*> regions() const;
    [[nodiscard]] std::vector<std::uint16_t> chosen() const;
    [[nodiscard]] QTreeWidgetItem* itemOf(std::uint16_t part) const;
    void change(const std::vector<std::uint16_t>& ids, const QString& what,
                const std::function<void(PartLook&)>& applied);
    void setLooks(const PartLooks& looks, const QString& text);
    [[nodiscard]] QString nameOf(const std::vector<std::uint16_t>& ids) const;
    void showOrHide(QTreeWidgetItem* item, int column);
    void showAll();
    void filter(const QString& words);
    void refresh();
    void refreshRegion(QTreeWidgetItem& region, const PartLooks& looks);
    void refreshButtons(const PartLooks& looks);

    SceneView* m_scene = nullptr;
    QPointer<ChangeHistory> m_history;
    QLineEdit* m_words;
    QTreeWidget* m_parts;
    std::vector<QPushButton*> m_styles;
    Switch m_highlight;
    Switch m_label;
    Switch m_plain; ///< shown only if a part has vertex colours
    QPushButton* m_showAll;
};

} // namespace carina
