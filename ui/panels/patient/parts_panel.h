#pragma once

#include "engine/core/ids.h"
#include "models/session/change_history.h"
#include "widgets/scene/look/part_look.h"

#include <QPointer>
#include <QWidget>

#include <functional>
#include <map>
#include <optional>
#include <string>
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

    /// Lists the parts that the view has now. Each station has its own looks and its own choice in
    /// the list: where they are of the same patient they come back, else all is as usual.
    /// @param station that is drawn; kNoStation in a program that has only one
    /// @param patient by its content hash; empty: another one than before
    /// @pre the view outlives the panel.
    void setScene(SceneView& scene, StationId station = kNoStation,
                  const std::string& patient = {});
    /// Adds its changes to a history from now on.
    void setHistory(ChangeHistory& history) { m_history = &history; }
    /// Chooses a part in the list, and no other; std::nullopt chooses none. A filter that hides it
    /// is cleared.
    void choose(std::optional<std::uint16_t> part);
    /// Shows the parts so, as one change.
    void put(const PartLooks& looks);
    /// What the part that is chosen is called; empty where none is, or several are.
    [[nodiscard]] QString chosenName() const;

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
    /// How it was at a station last.
    struct Kept {
        std::string patient;
        PartLooks looks;
        std::vector<std::uint16_t> chosen;
    };

    void list(const std::string& patient);
    void chooseAll(const std::vector<std::uint16_t>& parts);
    [[nodiscard]] std::vector<QTreeWidgetItem*> regions() const;
    [[nodiscard]] std::vector<std::uint16_t> chosen() const;
    [[nodiscard]] QTreeWidgetItem* itemOf(std::uint16_t part) const;
    void change(const std::vector<std::uint16_t>& ids, const QString& what,
                const std::function<void(PartLook&)>& applied);
    void setLooks(const PartLooks& looks, const QString& text);
    void setLooksAt(StationId station, const PartLooks& looks);
    [[nodiscard]] QString nameOf(const std::vector<std::uint16_t>& ids) const;
    void showOrHide(QTreeWidgetItem* item, int column);
    void showAll();
    void filter(const QString& words);
    void refresh();
    void refreshRegion(QTreeWidgetItem& region, const PartLooks& looks);
    void refreshButtons(const PartLooks& looks);

    SceneView* m_scene = nullptr;
    StationId m_station = kNoStation;
    std::string m_listed; ///< the patient whose parts are in the list
    std::map<StationId, Kept> m_kept;
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
