//! Unknown scenes and patches are refused.

use infoscene::scene::{Scene, SceneError};

#[test]
fn unknown_scenes_and_patches_are_refused() {
    for name in [
        "", "sphere", "cube:", "cube:0", "cube:257", "cube:-1", "cube:1.5",
    ] {
        assert!(
            matches!(Scene::built_in(name), Err(SceneError::UnknownName { .. })),
            "{name}"
        );
    }
    let refusal = Scene::built_in("two-squares")
        .unwrap()
        .rectangle(2)
        .unwrap_err();
    assert_eq!(refusal, SceneError::NoSuchPatch { index: 2, last: 1 });
    assert_eq!(Scene::try_new(Vec::new()).unwrap_err(), SceneError::Empty);
}
